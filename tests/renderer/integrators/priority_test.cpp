// SPDX-License-Identifier: Apache-2.0
// Which of two overlapping bodies is there does not depend on where one looks from.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/meshes.h"
#include "tests/support/poses.h"

namespace bouguer::renderer {
namespace {

using test::glass;
using test::Pose;
using test::PosedScene;
using test::Seen;

constexpr double kShare = 0.9, kFirst = 0.5, kSecond = 0.8;

HallMaterial body(double transmittance) {
    HallMaterial m = glass(1, transmittance);
    m.k_st = kShare;
    return m;
}

class Priority : public testing::TestWithParam<Pose> {
  protected:
    /// Two boxes from z = 0 to 3 and from 2 to 6, seen along z and the other way.
    static void expect_both_ways(int of_first, int of_second, double expected) {
        const Vec3 lo{-5, -5, 0}, hi{5, 5, 3}, lo2{-4, -4, 2}, hi2{4, 4, 6};
        for (const bool mesh : {false, true}) {
            for (const bool other_mesh : {false, true}) {
                PosedScene scene(GetParam());
                scene.environment(1);
                scene.add(test::box_or_mesh(mesh, lo, hi), body(kFirst), of_first);
                scene.add(test::box_or_mesh(other_mesh, lo2, hi2), body(kSecond), of_second);
                for (const Vec3 at : {Vec3{0.1, 0.2, 3}, Vec3{-1, -1, 3}}) {
                    const Seen down = scene.look(at + Vec3{0, 0, 9}, at);
                    const Seen up = scene.look(at - Vec3{0, 0, 9}, at);
                    EXPECT_NEAR(down.y, expected, 3e-6);
                    EXPECT_NEAR(up.y, expected, 3e-6);
                    EXPECT_TRUE(down.counters.lost_bodies.empty());
                    EXPECT_TRUE(up.counters.lost_bodies.empty());
                }
            }
        }
    }
};

TEST_P(Priority, TheHigherIsThere) {
    expect_both_ways(1, 0, std::pow(kShare, 3) * std::pow(kFirst, 3) * std::pow(kSecond, 3));
    expect_both_ways(-1, 0, std::pow(kShare, 3) * std::pow(kFirst, 2) * std::pow(kSecond, 4));
}

TEST_P(Priority, AtEqualOnesTheFirstIsThere) {
    expect_both_ways(0, 0, std::pow(kShare, 3) * std::pow(kFirst, 3) * std::pow(kSecond, 3));
}

// Slanted rays through overlapping balls and boxes of other indices: the share that is transmitted
// is the same for light that goes the same way back. The way back starts where the ray comes out.
TEST_P(Priority, LightGoesBackTheSameWay) {
    PosedScene scene(GetParam());
    scene.environment(1);
    HallMaterial glassy = body(0.5), watery = body(0.8);
    scene.add(Box{{-5, -5, 0}, {5, 5, 3}}, glassy, 1).add(Box{{-5, -5, 2}, {5, 5, 6}}, watery);
    const Vec3 d = normalize({0.4, -0.3, 1});
    for (int i = 0; i < 20; ++i) {
        const Vec3 at{0.1 * i - 1, 0.05 * i, 2.5};
        EXPECT_NEAR(scene.look(at - 9 * d, at).y, scene.look(at + 9 * d, at).y, 2e-6);
    }
}

// Where three bodies end at one wall, the one that counts most decides on its side alone.
TEST_P(Priority, HoldsWhereThreeBodiesShareAWall) {
    for (const int middle : {-1, 0, 1}) {
        PosedScene scene(GetParam());
        scene.environment(1);
        scene.add(Box{{-5, -5, 0}, {5, 5, 3}}, body(0.5));
        scene.add(test::box_mesh({-4, -4, 1}, {4, 4, 3}), body(0.6), middle);
        scene.add(Cylinder{{0, 0, 3}, {0, 0, 5}, 4}, body(0.7));
        // The second lies in the first, and counts there only with a higher priority.
        const double expected =
            middle == 1 ? std::pow(kShare, 4) * 0.5 * std::pow(0.6, 2) * std::pow(0.7, 2)
                        : std::pow(kShare, 3) * std::pow(0.5, 3) * std::pow(0.7, 2);
        EXPECT_NEAR(scene.look({0.3, 0.1, 9}, {0.3, 0.1, 0}).y, expected, 3e-6) << middle;
        EXPECT_NEAR(scene.look({0.3, 0.1, -9}, {0.3, 0.1, 0}).y, expected, 3e-6) << middle;
    }
}

// Of two bodies that fill the same room the one that counts is seen, with two faces.
TEST_P(Priority, OneBodyMayFillAnother) {
    const auto shapes = [] {
        return std::vector<Shape>{Box{{-1, -1, -1}, {1, 1, 1}}, test::cube(),
                                  test::box_mesh({-1, -1, -1}, {1, 1, 1})};
    };
    for (const Shape& a : shapes()) {
        for (const Shape& b : shapes()) {
            for (const int priority : {-1, 0, 1}) {
                PosedScene scene(GetParam());
                scene.environment(1);
                scene.add(a, body(0.5)).add(b, body(0.8), priority);
                const double t = priority == 1 ? 0.8 : 0.5;
                for (const Vec3 at : {Vec3{0, 0, 0}, Vec3{0.4, -0.3, 0}}) {
                    const Seen seen = scene.look(at + Vec3{0, 0, 5}, at);
                    EXPECT_NEAR(seen.y, kShare * kShare * t * t, 3e-6);
                    EXPECT_TRUE(seen.counters.lost_bodies.empty());
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Priority, testing::ValuesIn(test::poses()), test::pose_name);

}  // namespace
}  // namespace bouguer::renderer
