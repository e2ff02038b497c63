// SPDX-License-Identifier: Apache-2.0
#include "renderer/textures/uv_mapping.h"

#include <gtest/gtest.h>

#include <limits>

namespace bouguer::renderer {
namespace {

void expect_near(Vec2 found, Vec2 expected) {
    EXPECT_NEAR(found.x, expected.x, 1e-15);
    EXPECT_NEAR(found.y, expected.y, 1e-15);
}

TEST(UvMapping, ScalesByRepetitions) {
    expect_near(UvToTexture({{4, 2}, {}, 0})({0.25, 0.25}), {1, 0.5});
}

// Moved to the right, the texture's origin is found to the right.
TEST(UvMapping, MovesTheTexture) {
    expect_near(UvToTexture({{2, 2}, {0.3, -0.1}, 0})({0.3, -0.1}), {0, 0});
}

// Turned a quarter counter-clockwise, what pointed to the right points up.
TEST(UvMapping, TurnsCounterClockwise) {
    expect_near(UvToTexture({{1, 1}, {}, 90})({0, 0.5}), {0.5, 0});
    expect_near(UvToTexture({{1, 1}, {}, 90})({-0.5, 0}), {0, 0.5});
}

// First scaled, then turned, then moved: the place of texture point (1, 0.5) worked out by hand.
TEST(UvMapping, KeepsItsOrder) {
    expect_near(UvToTexture({{4, 2}, {1, 1}, 90})({1 - 0.25, 1 + 0.25}), {1, 0.5});
}

TEST(UvMapping, StaysFinite) {
    constexpr Real kNone = std::numeric_limits<Real>::quiet_NaN();
    expect_near(UvToTexture({})({kNone, std::numeric_limits<Real>::infinity()}), {0, 0});
    expect_near(UvToTexture({{1e300, 1}, {}, 0})({1e300, 0.5}), {0, 0.5});
}

TEST(Fraction, IsBelowOne) {
    EXPECT_EQ(fraction(2.25), 0.25);
    EXPECT_EQ(fraction(-0.25), 0.75);
    EXPECT_EQ(fraction(-1e-20), 0);
    EXPECT_EQ(fraction(1e300), 0);
}

}  // namespace
}  // namespace bouguer::renderer
