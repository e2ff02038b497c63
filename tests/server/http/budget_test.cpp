// SPDX-License-Identifier: Apache-2.0
#include "server/http/budget.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

TEST(Budget, IsBoundedForAClientAndForAll) {
    Budget budget(100, 40);
    Reservation a1(budget, "a");
    Reservation a2(budget, "a");
    Reservation b(budget, "b");
    Reservation c(budget, "c");
    EXPECT_TRUE(a1.try_resize(30));
    EXPECT_FALSE(a2.try_resize(11)) << "over the share";
    EXPECT_TRUE(a2.try_resize(10));
    EXPECT_TRUE(b.try_resize(40));
    EXPECT_FALSE(c.try_resize(21)) << "over the whole";
    EXPECT_EQ(c.bytes(), 0U);
    EXPECT_TRUE(c.try_resize(20));
    EXPECT_EQ(budget.used(), 100U);
    EXPECT_TRUE(a1.try_resize(0));
    EXPECT_TRUE(a2.try_resize(40));
}

TEST(Budget, IsGivenBackWithTheReservation) {
    Budget budget(100, 100);
    {
        Reservation first(budget, "a");
        ASSERT_TRUE(first.try_resize(60));
        Reservation moved = std::move(first);
        EXPECT_EQ(moved.bytes(), 60U);
        EXPECT_EQ(budget.used_by("a"), 60U);
        moved = Reservation(budget, "b");
        EXPECT_EQ(budget.used(), 0U) << "what was held before is let go of";
        ASSERT_TRUE(moved.try_resize(5));
    }
    EXPECT_EQ(budget.used(), 0U);
    EXPECT_EQ(budget.used_by("b"), 0U);
}

TEST(Budget, WhatIsNotAskedForCountsNevertheless) {
    Budget budget(100, 50);
    Reservation small(budget, "a");
    small.resize(120);
    Reservation other(budget, "b");
    EXPECT_FALSE(other.try_resize(1));
    EXPECT_TRUE(small.try_resize(110)) << "less is always granted";
    EXPECT_FALSE(small.try_resize(111));
}

TEST(Budget, AReservationOfNothingCannotGrow) {
    Reservation none;
    EXPECT_FALSE(none.try_resize(1));
    EXPECT_TRUE(none.try_resize(0));
}

}  // namespace
}  // namespace bouguer::server
