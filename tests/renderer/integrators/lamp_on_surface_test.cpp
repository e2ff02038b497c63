// SPDX-License-Identifier: Apache-2.0
// What holds a lamp does not shadow it.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/meshes.h"
#include "tests/support/poses.h"

namespace bouguer::renderer {
namespace {

using test::glass;
using test::matt;
using test::Pose;
using test::PosedScene;
using test::Seen;

struct Holder {
    const char* name;
    PlacedShape placed;
    bool is_sheet = false;
};

/// Everything whose lowest point is (0, 0, 3).
std::vector<Holder> holders() {
    const auto cube = test::cube();
    return {
        {"plane", {Plane{{0, 0, 3}, {0, 0, -1}}}, true},
        {"disk", {Disk{{0, 0, 3}, {0, 0, 1}, 2}}, true},
        {"box", {Box{{-2, -2, 3}, {2, 2, 4}}}},
        {"cylinder", {Cylinder{{0, 0, 3}, {0, 0, 4}, 2}}},
        {"lying cylinder", {Cylinder{{-2, 0, 3.5}, {2, 0, 3.5}, 0.5}}},
        {"sphere", {Sphere{{0, 0, 4}, 1}}},
        {"mesh", {test::box_mesh({-2, -2, 3}, {2, 2, 4})}},
        {"instances", {cube, {Transform::translate({0, 0, 4}), Transform::translate({20, 0, 4})}}}};
}

class LampOnSurface : public testing::TestWithParam<Pose> {};

/// A lamp of 9 W/sr 3 above the floor: 1 W/m^2 under it, less to the side.
double expected(Real x, Real y) {
    const Real squared = x * x + y * y + 9;
    return 0.8 * 9 / squared * 3 / std::sqrt(squared);
}

TEST_P(LampOnSurface, IsNotShadowedByIt) {
    for (const Holder& holder : holders()) {
        for (const bool is_glass : {false, true}) {
            PosedScene scene(GetParam());
            scene.place(holder.placed, is_glass ? glass(1.5, 0.5) : matt(0.5))
                .add(Plane{{0, 0, 0}, {0, 0, 1}}, matt(0.8))
                .lamp({0, 0, 3}, 9);
            for (const Vec3 at : {Vec3{0, 0, 0}, Vec3{1.5, -0.7, 0}, Vec3{-4, 9, 0}}) {
                const Seen seen = scene.look({at.x + 0.5, at.y, 1}, at);
                EXPECT_NEAR(seen.y, expected(at.x, at.y), 2e-6)
                    << holder.name << " " << is_glass << " " << at.x;
                EXPECT_TRUE(seen.counters.lost_bodies.empty()) << holder.name << " " << is_glass;
            }
        }
    }
}

// Behind what has an inside it stays dark; in a plane or a disk a lamp is on both sides.
TEST_P(LampOnSurface, StaysOnItsSide) {
    for (const Holder& holder : holders()) {
        if (holder.is_sheet) continue;
        PosedScene scene(GetParam());
        scene.place(holder.placed, matt(0.5))
            .add(Plane{{0, 0, 9}, {0, 0, -1}}, matt(0.8))
            .lamp({0, 0, 3}, 9);
        EXPECT_EQ(scene.look({0.5, 0, 8}, {0.1, 0.2, 9}).y, 0) << holder.name;
    }
}

// A lamp that lies on a glass plate lights the floor through it: 1 thick, two faces.
TEST_P(LampOnSurface, ShinesThroughWhatItLiesOn) {
    for (const bool mesh : {false, true}) {
        HallMaterial plate = glass(1.5, 0.6);
        plate.k_st = 0.9;
        PosedScene scene(GetParam());
        const Vec3 lo{-2, -2, 2}, hi{2, 2, 3};
        scene.add(test::box_or_mesh(mesh, lo, hi), plate)
            .add(Plane{{0, 0, 0}, {0, 0, 1}}, matt(0.8))
            .lamp({0, 0, 3}, 9);
        EXPECT_NEAR(scene.look({0.5, 0, 1}, {0, 0, 0}).y, 0.8 * 0.6 * 0.9, 0.8 * 0.6 * 0.9 * 0.11)
            << "with or without the face that it lies on";
    }
}

INSTANTIATE_TEST_SUITE_P(All, LampOnSurface, testing::ValuesIn(test::poses()), test::pose_name);

}  // namespace
}  // namespace bouguer::renderer
