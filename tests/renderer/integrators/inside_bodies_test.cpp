// SPDX-License-Identifier: Apache-2.0
// Cameras and lamps that stand in bodies.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/meshes.h"
#include "tests/support/poses.h"

namespace bouguer::renderer {
namespace {

using test::clear;
using test::glass;
using test::matt;
using test::Pose;
using test::PosedScene;
using test::Seen;

constexpr double kShare = 0.9;

HallMaterial body(double ior, double transmittance) {
    HallMaterial m = glass(ior, transmittance);
    m.k_st = kShare;
    return m;
}

/// Shapes that reach from their middle, zero, to 2 along z.
std::vector<Shape> shapes() {
    return {Sphere{{0, 0, 0}, 2},
            Box{{-2, -2, -2}, {2, 2, 2}},
            Cylinder{{0, 0, -2}, {0, 0, 2}, 2},
            Cylinder{{0, -2, 0}, {0, 2, 0}, 2},
            test::box_mesh({-2, -2, -2}, {2, 2, 2}),
            test::prism(2, -2, 2, 8),
            Plane{{0, 0, 2}, {0, 0, 1}}};
}

class InsideBodies : public testing::TestWithParam<Pose> {
  protected:
    PosedScene scene() const { return PosedScene(GetParam()); }
};

// 1.5 of 0.7 a unit and one face.
TEST_P(InsideBodies, ACameraLooksOut) {
    for (const Shape& shape : shapes()) {
        PosedScene s = scene();
        s.environment(1).add(shape, body(1.5, 0.7));
        const Seen seen = s.look({0, 0, 0.5}, {0, 0, 9});
        EXPECT_NEAR(seen.y, kShare * std::pow(0.7, 1.5), 2e-6) << shape.index();
        EXPECT_TRUE(seen.counters.lost_bodies.empty()) << shape.index();
    }
}

// In a ball in a box in a ball: 0.5, 1 and 1.
TEST_P(InsideBodies, ACameraLooksOutOfSeveral) {
    PosedScene s = scene();
    s.environment(1)
        .add(Sphere{{0, 0, 0}, 3}, body(1.2, 0.9))
        .add(Box{{-2, -2, -2}, {2, 2, 2}}, body(1.3, 0.8), 1)
        .add(test::box_mesh({-1, -1, -1}, {1, 1, 1}), body(1.4, 0.7), 2);
    const double expected = std::pow(kShare, 3) * 0.9 * 0.8 * std::pow(0.7, 0.5);
    const Seen seen = s.look({0, 0, 0.5}, {0, 0, 9});
    EXPECT_NEAR(seen.y, expected, 2e-6);
    EXPECT_TRUE(seen.counters.lost_bodies.empty());
}

// Under water 3 deep: up through it; straight down into it, to the ground at 5.
TEST_P(InsideBodies, ACameraDives) {
    PosedScene s = scene();
    s.environment(1)
        .add(Plane{{0, 0, 0}, {0, 0, 1}}, body(1.33, 0.7))
        .add(Box{{-9, -9, -6}, {9, 9, -5}}, matt(0))
        .shining(2);
    const Seen up = s.look({1, 1, -3}, {1, 1, 0}), down = s.look({1, 1, -3}, {1, 1, -9});
    EXPECT_NEAR(up.y, kShare * std::pow(0.7, 3), 2e-6);
    EXPECT_NEAR(down.y, 2 * std::pow(0.7, 2), 2e-6);
    EXPECT_TRUE(up.counters.lost_bodies.empty());
    EXPECT_TRUE(down.counters.lost_bodies.empty());
    // Into water without end nothing comes back, and a ray that ends there has lost nothing.
    PosedScene sea = scene();
    sea.environment(1).add(Plane{{0, 0, 0}, {0, 0, 1}}, body(1.33, 0.7));
    const Seen deep = sea.look({1, 1, -3}, {1, 1, -9});
    EXPECT_EQ(deep.y, 0);
    EXPECT_TRUE(deep.counters.lost_bodies.empty());
}

// A camera just at a face sees what lies in the direction that it looks in.
TEST_P(InsideBodies, ACameraMayStandInAFace) {
    for (const Shape& shape : shapes()) {
        if (std::holds_alternative<Plane>(shape)) continue;
        PosedScene s = scene();
        HallMaterial m = glass(1, 0.7);
        s.environment(1).add(shape, m);
        EXPECT_NEAR(s.look({0, 0, 2}, {0, 0, 9}).y, 1, 2e-6) << shape.index();
        EXPECT_NEAR(s.look({0, 0, 2}, {0, 0, -9}).y, std::pow(0.7, 4), 3e-6) << shape.index();
    }
}

// A lamp in the middle lights a wall 6 away through 2 of glass and one face.
TEST_P(InsideBodies, ALampShinesOut) {
    for (const Shape& shape : shapes()) {
        PosedScene s = scene();
        s.add(shape, body(1.5, 0.7))
            .add(Box{{-9, -9, 6}, {9, 9, 7}}, matt(0.8))
            .lamp({0, 0, 0}, 36);
        const Seen seen = s.look({0, 3, 4}, {0, 0, 6});
        EXPECT_NEAR(seen.y, 0.8 * kShare * std::pow(0.7, 2), 2e-6) << shape.index();
        EXPECT_TRUE(seen.counters.lost_bodies.empty()) << shape.index();
    }
}

// Camera, lamp and matt ball in one body: no face between them.
TEST_P(InsideBodies, AllMayBeInOneBody) {
    PosedScene s = scene();
    s.add(Sphere{{0, 0, 0}, 10}, body(1.5, 0.7))
        .add(Box{{-1, -1, -1}, {1, 1, 0}}, matt(0.8))
        .lamp({0, 0, 2}, 4);
    const Seen seen = s.look({0, 0, 3}, {0, 0, 0});
    EXPECT_NEAR(seen.y, 0.8 * std::pow(0.7, 5), 2e-6);
    EXPECT_TRUE(seen.counters.lost_bodies.empty());
}

INSTANTIATE_TEST_SUITE_P(All, InsideBodies, testing::ValuesIn(test::poses()), test::pose_name);

}  // namespace
}  // namespace bouguer::renderer
