// SPDX-License-Identifier: Apache-2.0
// A liquid in its glass: modelled by a shared wall, by overlap, and by one body in the other, it is
// the same picture.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/renderer/geometry/geometry_testing.h"
#include "tests/support/meshes.h"
#include "tests/support/poses.h"

namespace bouguer::renderer {
namespace {

using test::clear;
using test::glass;
using test::Pose;
using test::PosedScene;
using test::Seen;

using MeshPtr = std::shared_ptr<const TriangleMesh>;

/// `outer` with the hollow that `inner` fills.
MeshPtr hollow(const MeshPtr& outer, const MeshPtr& inner) {
    TriangleMesh mesh = *outer;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), inner->positions.begin(), inner->positions.end());
    for (const auto& [a, b, c] : inner->triangles)
        mesh.triangles.push_back({first + a, first + c, first + b});
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

MeshPtr scaled(const MeshPtr& mesh, Real by) {
    TriangleMesh copy = *mesh;
    for (Vec3& p : copy.positions) p = by * p;
    return std::make_shared<const TriangleMesh>(std::move(copy));
}

const HallMaterial kGlass = [] {
    HallMaterial m = glass(1.5, 0.9);
    m.k_st = 0.95;
    return m;
}();
const HallMaterial kLiquid = [] {
    HallMaterial m = glass(1.33, 0.6);
    m.k_st = 0.95;
    return m;
}();

class Liquid : public testing::TestWithParam<Pose> {
  protected:
    /// What 60 rays through the middle of the scene see.
    static std::vector<double> picture(PosedScene& scene) {
        test::Random random(3);
        std::vector<double> all;
        for (int i = 0; i < 60; ++i) {
            const Vec3 from = 9 * random.direction();
            const Seen seen = scene.look(from, random.in_cube(1.2));
            EXPECT_TRUE(seen.counters.lost_bodies.empty()) << i;
            all.push_back(seen.y);
        }
        return all;
    }
    static void expect_same(PosedScene& a, PosedScene& b) {
        const auto one = picture(a), other = picture(b);
        for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(one[i], other[i], 1e-5) << i;
    }
    PosedScene scene() const {
        PosedScene scene(GetParam());
        scene.environment(1);
        return scene;
    }
};

TEST_P(Liquid, InABoxIsOnePicture) {
    const auto outer = test::box_mesh({-2, -2, -2}, {2, 2, 2});
    const auto inner = test::box_mesh({-1, -1.5, -1.2}, {1.1, 1, 1.3});
    const Box filling{{-1, -1.5, -1.2}, {1.1, 1, 1.3}};
    PosedScene nested = scene(), wall = scene(), wall_of_box = scene(), overlap = scene();
    nested.add(Box{{-2, -2, -2}, {2, 2, 2}}, kGlass).add(filling, kLiquid, 1);
    wall.add(hollow(outer, inner), kGlass).add(inner, kLiquid);
    wall_of_box.add(filling, kLiquid).add(hollow(outer, inner), kGlass);
    overlap.add(hollow(outer, inner), kGlass, 1)
        .add(Box{{-1.3, -1.6, -1.4}, {1.4, 1.2, 1.5}}, kLiquid);
    expect_same(nested, wall);
    expect_same(nested, wall_of_box);
    expect_same(nested, overlap);
}

// The glass is a prism of 12 sides; what fills it, a prism of the same sides, and for the overlap a
// true cylinder that reaches into the wall.
TEST_P(Liquid, InAPrismIsOnePicture) {
    const auto outer = test::prism(2, -2, 2, 12);
    const auto inner = test::prism(1.5, -1.5, 1.5, 12);
    PosedScene wall = scene(), overlap = scene(), instances = scene();
    wall.add(hollow(outer, inner), kGlass).add(inner, kLiquid);
    overlap.add(hollow(outer, inner), kGlass, 1)
        .add(Cylinder{{0, 0, -1.6}, {0, 0, 1.6}, 1.6}, kLiquid);
    const auto once = Transform::scale({1.5, 1.5, 1.5});
    instances.add(hollow(outer, inner), kGlass)
        .place({test::prism(1, -1, 1, 12), {once, Transform::translate({70, 0, 0}) * once}},
               kLiquid);
    expect_same(wall, overlap);
    expect_same(wall, instances);
}

// In the glass of a true cylinder stands a cylinder of liquid, whose bottom and side are the
// glass's own: the liquid counts more, or stands in front.
TEST_P(Liquid, InACylinderIsOnePicture) {
    PosedScene first = scene(), higher = scene();
    const Cylinder outer{{0, 0, -2}, {0, 0, 2}, 2}, inner{{0, 0, -2}, {0, 0, 1}, 2};
    first.add(inner, kLiquid).add(outer, kGlass);
    higher.add(outer, kGlass).add(inner, kLiquid, 1);
    expect_same(first, higher);
    // From above: 1 of glass, 3 of liquid, three faces.
    EXPECT_NEAR(first.look({0.2, 0.3, 9}, {0.2, 0.3, 0}).y,
                std::pow(0.95, 3) * 0.9 * std::pow(0.6, 3), 1e-6);
}

// Through the middle of a ball of radius 2 whose hollow of 1.5 is full: 2 * 0.5 of glass, 2 * 1.5
// of liquid, four faces.
TEST_P(Liquid, FillsAHollowBall) {
    const double expected = std::pow(0.95, 4) * 0.9 * std::pow(0.6, 3);
    const Sphere outer{{0, 0, 0}, 2}, inner{{0, 0, 0}, 1.5};
    for (const bool glass_first : {true, false}) {
        PosedScene ball = scene();
        if (glass_first) {
            ball.add(outer, kGlass).add(inner, kLiquid, 1);
        } else {
            ball.add(inner, kLiquid).add(outer, kGlass);
        }
        EXPECT_NEAR(ball.look({4, 5, 6}, {0, 0, 0}).y, expected, 1e-5);
    }
}

// As meshes: along the normal of a facet, which lies at a share of the radius.
TEST_P(Liquid, FillsAHollowBallOfTriangles) {
    const auto unit = test::icosphere(1);
    const auto& [a, b, c] = unit->triangles[5];
    const auto& p = unit->positions;
    const Vec3 n = normalize(cross(p[b] - p[a], p[c] - p[a]));
    const Real share = dot(n, p[a]);
    PosedScene wall = scene(), overlap = scene();
    wall.add(hollow(scaled(unit, 2), scaled(unit, 1.5)), kGlass).add(scaled(unit, 1.5), kLiquid);
    overlap.add(hollow(scaled(unit, 2), scaled(unit, 1.5)), kGlass, 1)
        .add(Sphere{{0, 0, 0}, 1.6}, kLiquid);
    const double expected = std::pow(0.95, 4) * std::pow(0.9, share) * std::pow(0.6, 3 * share);
    EXPECT_NEAR(wall.look(9 * n, {0, 0, 0}).y, expected, 1e-5);
    EXPECT_NEAR(overlap.look(9 * n, {0, 0, 0}).y, expected, 1e-5);
    expect_same(wall, overlap);
}

// An air bubble: a body of index 1 that absorbs nothing and counts more.
TEST_P(Liquid, MayHoldABubble) {
    PosedScene ball = scene();
    ball.add(Sphere{{0, 0, 0}, 2}, glass(1.5, 0.6)).add(Sphere{{0, 0, 0}, 1}, clear(1), 1);
    EXPECT_NEAR(ball.look({4, 5, 6}, {0, 0, 0}).y, 0.36, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(All, Liquid, testing::ValuesIn(test::poses()), test::pose_name);

}  // namespace
}  // namespace bouguer::renderer
