// SPDX-License-Identifier: Apache-2.0
#include "renderer/media/medium_stack.h"

#include <gtest/gtest.h>

namespace bouguer::renderer {
namespace {

// Whatever the order in which bodies are entered and left, the one with the lowest number is there:
// that is what makes light find the same bodies on the way back [Schmidt and Budge 2002].
TEST(MediumStack, HoldsTheBodyThatCounts) {
    MediumStack media;
    EXPECT_EQ(media.current(), MediumStack::kOutside);
    EXPECT_TRUE(media.enter(1));
    EXPECT_TRUE(media.enter(2));
    EXPECT_EQ(media.current(), 1U);
    EXPECT_TRUE(media.leave(1)) << "overlapping bodies are left in any order";
    EXPECT_EQ(media.current(), 2U);
    EXPECT_TRUE(media.enter(0));
    EXPECT_EQ(media.current(), 0U);
    EXPECT_FALSE(media.leave(1));
    EXPECT_TRUE(media.leave(2));
    EXPECT_TRUE(media.leave(0));
    EXPECT_EQ(media.current(), MediumStack::kOutside);
}

TEST(MediumStack, CountsABodyWhosePartsOverlap) {
    MediumStack media;
    EXPECT_TRUE(media.enter(7));
    EXPECT_TRUE(media.enter(7));
    EXPECT_EQ(media.count(7), 2U);
    EXPECT_TRUE(media.leave(7));
    EXPECT_TRUE(media.holds(7));
    EXPECT_TRUE(media.leave(7));
    EXPECT_FALSE(media.holds(7));
}

TEST(MediumStack, RefusesWhenFull) {
    MediumStack media;
    for (BodyId i = 0; i < MediumStack::kCapacity; ++i) EXPECT_TRUE(media.enter(i));
    EXPECT_FALSE(media.enter(99));
    EXPECT_EQ(media.current(), 0U);
}

}  // namespace
}  // namespace bouguer::renderer
