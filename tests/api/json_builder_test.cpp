// SPDX-License-Identifier: Apache-2.0
#include "api/json_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace bouguer::api {
namespace {

TEST(JsonBuilder, WritesMembersInTheirOrder) {
    const std::string text = JsonObject()
                                 .set("name", "a \"quoted\" name")
                                 .set("samples", 16U)
                                 .set("seconds", 0.5)
                                 .set("final", true)
                                 .set("eta", std::optional<double>())
                                 .set_json("tags", JsonArray().add("x").add_json("1").text())
                                 .text();
    EXPECT_EQ(text,
              R"({"name":"a \"quoted\" name","samples":16,"seconds":0.5,"final":true,"eta":null,)"
              R"("tags":["x",1]})");
}

TEST(JsonBuilder, WritesNoNumberThatIsNotFinite) {
    EXPECT_EQ(json_number(std::nan("")), "null");
    EXPECT_EQ(json_number(std::numeric_limits<double>::infinity()), "null");
    EXPECT_EQ(json_number(0.1), "0.1");
}

// U+FFFD stands for bytes that are no UTF-8.
TEST(JsonBuilder, ReplacesBytesThatAreNoText) {
    EXPECT_EQ(json_string("a\xff\n"), "\"a\xef\xbf\xbd\\n\"");
}

TEST(JsonBuilder, WritesEmptyContainers) {
    EXPECT_EQ(JsonObject().text(), "{}");
    EXPECT_EQ(JsonArray().text(), "[]");
}

}  // namespace
}  // namespace bouguer::api
