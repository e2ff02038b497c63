// SPDX-License-Identifier: Apache-2.0
// A glass body that stands on a matt one: every pair of shapes, in every place and size. Their
// faces are one interface: light goes into the glass, to the matt surface, and out again.
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

struct Body {
    const char* name;
    PlacedShape placed;
    bool is_round = false;  ///< touches in one point, (0, 0, 0)
};

/// The second stands far away.
PlacedShape twice(Shape shape) {
    return {std::move(shape), {Transform{}, Transform::translate({30, 0, 0})}};
}

/// Things whose top lies in z = 0.
std::vector<Body> lower_bodies() {
    return {{"plane", {Plane{{0, 0, 0}, {0, 0, 1}}}},
            {"disk", {Disk{{0, 0, 0}, {0, 0, 1}, 6}}},
            {"box", {Box{{-6, -6, -2}, {6, 6, 0}}}},
            {"cylinder", {Cylinder{{0, 0, -2}, {0, 0, 0}, 6}}},
            {"lying cylinder", {Cylinder{{0, -6, -2}, {0, 6, -2}, 2}}, true},
            {"sphere", {Sphere{{0, 0, -2}, 2}}, true},
            {"mesh", {test::box_mesh({-6, -6, -2}, {6, 6, 0})}},
            {"prism", {test::prism(6, -2, 0, 7)}},
            {"instances", twice(test::box_mesh({-6, -6, -2}, {6, 6, 0}))}};
}

/// Things of height 1 that stand on z = 0.
std::vector<Body> glass_bodies() {
    return {{"box", {Box{{-5, -5, 0}, {5, 5, 1}}}},
            {"cylinder", {Cylinder{{0, 0, 0}, {0, 0, 1}, 5}}},
            {"lying cylinder", {Cylinder{{0, -6, 0.5}, {0, 6, 0.5}, 0.5}}, true},
            {"sphere", {Sphere{{0, 0, 0.5}, 0.5}}, true},
            {"mesh", {test::box_mesh({-5, -5, 0}, {5, 5, 1})}},
            {"prism", {test::prism(5, 0, 1, 9)}},
            {"instances", twice(test::box_mesh({-5, -5, 0}, {5, 5, 1}))}};
}

constexpr double kReflectance = 0.8, kShare = 0.9, kTransmittance = 0.7, kIndex = 1.5;

HallMaterial glass_of_the_table() {
    HallMaterial m = glass(kIndex, kTransmittance);
    m.k_st = kShare;
    return m;
}

/// The point q of z = 0 seen at `angle` from the normal, refracted at z = 1.
Seen look_through(PosedScene& scene, Vec3 q, Real angle) {
    const Real inside = std::asin(std::sin(angle) / kIndex);
    const Vec3 top = q + Vec3{std::tan(inside), 0, 1};
    return scene.look(top + 4 * Vec3{std::sin(angle), 0, std::cos(angle)}, top);
}

/// The sun stands at 0.4 from the normal, straight above what is round. Its light goes straight
/// through the upper face, as equation 3 has it.
double expected(Real sun, Real angle) {
    const Real inside = std::asin(std::sin(angle) / kIndex);
    const Real way = 1 / std::cos(sun) + 1 / std::cos(inside);
    return kReflectance * std::cos(sun) * kShare * kShare * std::pow(kTransmittance, way);
}

class Contact : public testing::TestWithParam<Pose> {};

TEST_P(Contact, ShowsTheMattSurface) {
    for (const Body& lower : lower_bodies()) {
        for (const Body& upper : glass_bodies()) {
            for (const bool glass_first : {true, false}) {
                SCOPED_TRACE(std::string(upper.name) + " on " + lower.name);
                const bool is_round = lower.is_round || upper.is_round;
                const Real sun = is_round ? 0 : 0.4;
                PosedScene scene(GetParam());
                if (glass_first)
                    scene.place(upper.placed, glass_of_the_table(), 0, is_round ? 0 : 0.3);
                scene.place(lower.placed, matt(kReflectance), 0, is_round ? 0 : 1.1);
                if (!glass_first)
                    scene.place(upper.placed, glass_of_the_table(), 0, is_round ? 0 : 0.3);
                scene.sun({0, std::sin(sun), -std::cos(sun)});
                const auto check = [&](Vec3 q, Real angle) {
                    const Seen seen = look_through(scene, q, angle);
                    EXPECT_NEAR(seen.y, expected(sun, angle), 2e-6)
                        << q.x << " " << q.y << " " << angle;
                    EXPECT_TRUE(seen.counters.lost_bodies.empty());
                };
                check({0, 0, 0}, 0);
                if (is_round) continue;
                check({0.3, -0.4, 0}, 0.5);
                check({-1.1, 0.7, 0}, 1.3);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Contact, testing::ValuesIn(test::poses()), test::pose_name);

}  // namespace
}  // namespace bouguer::renderer
