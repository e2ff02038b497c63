// SPDX-License-Identifier: Apache-2.0
#include "server/http/admission.h"

#include <gtest/gtest.h>

#include <vector>

namespace bouguer::server {
namespace {

TEST(Admission, IsBoundedForAClientAndForAll) {
    Admission admission(3, 2);
    std::vector<std::optional<Place>> places;
    places.push_back(admission.admit("a"));
    places.push_back(admission.admit("a"));
    EXPECT_TRUE(places[1]);
    EXPECT_FALSE(admission.admit("a")) << "over its share";
    places.push_back(admission.admit("b"));
    EXPECT_TRUE(places[2]);
    EXPECT_FALSE(admission.admit("c")) << "all are taken";
    EXPECT_EQ(admission.taken(), 3U);
    places.erase(places.begin());
    EXPECT_TRUE(admission.admit("a"));
}

TEST(Admission, APlaceMovesAndMayOutliveIt) {
    std::optional<Place> place;
    {
        Admission admission(1, 1);
        place = admission.admit("a");
        ASSERT_TRUE(place);
        const Place moved = std::move(*place);
        EXPECT_EQ(admission.taken(), 1U);
        place.reset();
        EXPECT_EQ(admission.taken(), 1U) << "it lives where it was moved to";
    }
}

}  // namespace
}  // namespace bouguer::server
