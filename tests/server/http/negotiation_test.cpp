// SPDX-License-Identifier: Apache-2.0
#include "server/http/negotiation.h"

#include <gtest/gtest.h>

#include <array>

namespace bouguer::server {
namespace {

constexpr std::array<std::string_view, 2> kOffers{"image/png", "image/x-exr"};

TEST(Negotiation, TakesTheBestOfWhatIsAccepted) {
    EXPECT_EQ(negotiate("", kOffers), 0U);
    EXPECT_EQ(negotiate("*/*", kOffers), 0U);
    EXPECT_EQ(negotiate("image/*", kOffers), 0U);
    EXPECT_EQ(negotiate("IMAGE/X-EXR", kOffers), 1U);
    EXPECT_EQ(negotiate("image/png;q=0.5, image/x-exr;q=0.9", kOffers), 1U);
    EXPECT_EQ(negotiate("text/html, image/x-exr;level=1", kOffers), 1U);
}

// RFC 9110 §12.5.1: the most specific range counts, not the most generous.
TEST(Negotiation, TheMostSpecificRangeCounts) {
    EXPECT_EQ(negotiate("image/png;q=0.1, */*;q=0.9", kOffers), 1U);
    EXPECT_EQ(negotiate("image/*;q=0.2, image/x-exr;q=0, */*", kOffers), 0U);
}

TEST(Negotiation, NothingWhenNoneIsAcceptable) {
    EXPECT_EQ(negotiate("text/html", kOffers), std::nullopt);
    EXPECT_EQ(negotiate("image/png;q=0, image/x-exr;q=0.0", kOffers), std::nullopt);
    EXPECT_EQ(negotiate("image", kOffers), std::nullopt);
    EXPECT_EQ(negotiate(",;,/,", kOffers), std::nullopt);
    EXPECT_EQ(negotiate("image/png;q=much", kOffers), std::nullopt);
}

}  // namespace
}  // namespace bouguer::server
