// SPDX-License-Identifier: Apache-2.0
#include "api/nearest_name.h"

#include <gtest/gtest.h>

namespace bouguer::api {
namespace {

TEST(NearestName, CountsEditsAndSwapsOfNeighbours) {
    EXPECT_EQ(edit_distance("", "abc"), 3U);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
    EXPECT_EQ(edit_distance("form", "from"), 1U);
    EXPECT_EQ(edit_distance("same", "same"), 0U);
}

TEST(NearestName, SuggestsOnlyWhatIsNear) {
    EXPECT_EQ(nearest_name("metarial", {"material", "shape"}), "material");
    EXPECT_EQ(nearest_name("colour", {"material", "shape"}), "");
    EXPECT_EQ(nearest_name("x", {"y"}), "y");
    EXPECT_EQ(nearest_name(std::string(1000, 'a'), {"a"}), "");
    EXPECT_EQ(did_you_mean("form", {"at", "from"}), " Did you mean \"from\"?");
    EXPECT_EQ(did_you_mean("nothing", {}), "");
}

TEST(NearestName, ListsAtMostTwentyWords) {
    EXPECT_EQ(quoted_list({"a", "b"}), "\"a\", \"b\"");
    EXPECT_EQ(quoted_list(std::vector<std::string_view>(21, "x")).substr(19 * 5), "\"x\" ...");
}

}  // namespace
}  // namespace bouguer::api
