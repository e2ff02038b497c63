// SPDX-License-Identifier: Apache-2.0
// Where rays meet each shape: closed forms.
#include <gtest/gtest.h>

#include "renderer/geometry/geometry.h"
#include "tests/support/meshes.h"

namespace bouguer::renderer {
namespace {

std::unique_ptr<const Geometry> build(std::vector<PlacedShape> shapes) {
    auto geometry = Geometry::build(shapes);
    EXPECT_TRUE(geometry) << geometry.error().message;
    return std::move(*geometry);
}

/// Shoots a ray given in world coordinates and moves the hit back to them.
std::optional<Hit> shoot(const Geometry& geometry, Vec3 from, Vec3 towards) {
    auto hit = geometry.intersect({from - geometry.origin(), normalize(towards)});
    if (hit) hit->p += geometry.origin();
    return hit;
}

void expect_near(Vec3 a, Vec3 b, Real tolerance) {
    EXPECT_LE(length(a - b), tolerance) << "(" << a.x << ", " << a.y << ", " << a.z << ") is not ("
                                        << b.x << ", " << b.y << ", " << b.z << ")";
}

TEST(Intersection, SphereOutsideAndInside) {
    const auto g = build({{Sphere{{1, 2, 3}, 2}}});
    const auto front = shoot(*g, {1, 2, -10}, {0, 0, 1});
    ASSERT_TRUE(front);
    EXPECT_NEAR(front->t, 11, 1e-12);
    expect_near(front->p, {1, 2, 1}, 1e-12);
    expect_near(front->ng, {0, 0, -1}, 1e-12);
    const auto back = shoot(*g, {1, 2, 3}, {0, 1, 0});
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->t, 2, 1e-12);
    expect_near(back->ng, {0, 1, 0}, 1e-12);
    EXPECT_FALSE(shoot(*g, {1, 4.001, -10}, {0, 0, 1}));
    EXPECT_TRUE(shoot(*g, {1, 3.999, -10}, {0, 0, 1}));
}

TEST(Intersection, MeshCube) {
    const auto g = build({{test::cube()}});
    const auto hit = shoot(*g, {0.3, 0.2, 5}, {0, 0, -1});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 4, 1e-12);
    expect_near(hit->ng, {0, 0, 1}, 1e-12);
    const auto inside = shoot(*g, {0, 0, 0}, {1, 0.1, 0.2});
    ASSERT_TRUE(inside);
    EXPECT_NEAR(inside->p.x, 1, 1e-12);
    expect_near(inside->ng, {1, 0, 0}, 1e-12);
}

TEST(Intersection, SphereOverPlane) {
    const auto g = build({{Sphere{{0, 1, 0}, 1}}, {Plane{{0, 0, 0}, {0, 1, 0}}}});
    const auto plane = shoot(*g, {3, 4, 0}, {0, -1, 0});
    ASSERT_TRUE(plane);
    EXPECT_EQ(plane->object, 1U);
    EXPECT_NEAR(plane->t, 4, 1e-12);
    const auto sphere = shoot(*g, {0, 4, 0}, {0, -1, 0});
    ASSERT_TRUE(sphere);
    EXPECT_EQ(sphere->object, 0U);
    EXPECT_NEAR(sphere->t, 2, 1e-12);
}

}  // namespace
}  // namespace bouguer::renderer
