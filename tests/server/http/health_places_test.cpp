// SPDX-License-Identifier: Apache-2.0
#include "server/http/health_places.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

TEST(HealthPlaces, TheOldestGivesWay) {
    HealthPlaces places(2, 2);
    auto first = places.take(1, "a");
    auto second = places.take(2, "b");
    EXPECT_FALSE(first.gives_way);
    EXPECT_FALSE(second.gives_way);
    EXPECT_EQ(places.take(3, "c").gives_way, 1U);
}

TEST(HealthPlaces, WhoeverHasItsShareLosesOneOfItsOwn) {
    HealthPlaces places(10, 2);
    const auto other = places.take(1, "b");
    const auto first = places.take(2, "a");
    const auto second = places.take(3, "a");
    const auto third = places.take(4, "a");
    EXPECT_EQ(third.gives_way, 2U) << "and not 1, which is older but another client's";
    EXPECT_EQ(places.taken(), 3U);
}

TEST(HealthPlaces, APlaceIsFreeWhenItsConnectionIsGone) {
    HealthPlaces places(1, 1);
    { const auto gone = places.take(1, "a"); }
    EXPECT_EQ(places.taken(), 0U);
    auto stays = places.take(2, "a");
    const HealthPlaces::Seat moved = std::move(stays.seat);
    EXPECT_EQ(places.taken(), 1U);
    EXPECT_EQ(places.take(3, "a").gives_way, 2U);
}

}  // namespace
}  // namespace bouguer::server
