// SPDX-License-Identifier: Apache-2.0
#include "renderer/core/transform.h"

#include <gtest/gtest.h>

namespace bouguer::renderer {
namespace {

void expect_near(Vec3 a, Vec3 b, Real tolerance = 1e-14) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

// A right-handed quarter turn about z takes x to y.
TEST(Transform, TurnsRightHanded) {
    expect_near(Transform::rotate({0, 0, 2}, kPi / 2).point({1, 0, 0}), {0, 1, 0});
    expect_near(Transform::rotate({1, 0, 0}, kPi / 2).point({0, 1, 0}), {0, 0, 1});
}

// (A B) p = A (B p): scaled first, then moved.
TEST(Transform, ComposesFromTheRight) {
    const Transform m = Transform::translate({1, 2, 3}) * Transform::scale({2, 2, 2});
    expect_near(m.point({1, 1, 1}), {3, 4, 5});
}

TEST(Transform, InverseUndoes) {
    const Transform m = Transform::translate({1, -2, 3}) * Transform::rotate({1, 2, 3}, 0.7) *
                        Transform::scale({0.5, 4, 1e-3});
    const auto inverse = m.inverse();
    ASSERT_TRUE(inverse);
    expect_near(inverse->point(m.point({5, 6, 7})), {5, 6, 7}, 1e-11);
}

TEST(Transform, HasNoInverseWhenFlat) {
    EXPECT_FALSE(Transform::scale({1, 0, 1}).inverse());
    EXPECT_FALSE(Transform::scale({1, std::nan(""), 1}).inverse());
}

}  // namespace
}  // namespace bouguer::renderer
