// SPDX-License-Identifier: Apache-2.0
// Where rays meet each shape: closed forms.
#include <limits>

#include "tests/renderer/geometry/geometry_testing.h"
#include "tests/support/meshes.h"

namespace bouguer::renderer {
namespace {

using test::build;
using test::expect_near;
using test::shoot;

constexpr Real kTight = 1e-12;

/// That the ray meets the scene at `t`, with this normal.
void expect_hit(const Geometry& geometry, Vec3 from, Vec3 towards, Real t, Vec3 ng) {
    const auto hit = shoot(geometry, from, towards);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, t, kTight);
    expect_near(hit->p, from + t * normalize(towards), kTight);
    expect_near(hit->ng, ng, kTight);
    EXPECT_GE(dot(hit->ng, hit->ns), 0);
}

TEST(Intersection, Sphere) {
    const auto g = build({{Sphere{{1, 2, 3}, 2}}});
    expect_hit(*g, {1, 2, -10}, {0, 0, 1}, 11, {0, 0, -1});
    expect_hit(*g, {1, 2, 3}, {0, 1, 0}, 2, {0, 1, 0});  // from the middle
    // Half a radius off the axis: the normal is at 30 degrees, z = 3 - 2 cos 30.
    expect_hit(*g, {2, 2, -10}, {0, 0, 1}, 13 - std::sqrt(3.0), {0.5, 0, -std::sqrt(0.75)});
    EXPECT_FALSE(shoot(*g, {1, 4 + 1e-9, -10}, {0, 0, 1}));
    EXPECT_TRUE(shoot(*g, {1, 4 - 1e-9, -10}, {0, 0, 1}));
    EXPECT_FALSE(shoot(*g, {1, 2, -10}, {0, 0, -1}));  // behind the ray
}

// Half axes 3, 1 and 1/2: the normal at p is along (x/9, y, 4z).
TEST(Intersection, SphereScaledToAnEllipsoid) {
    const auto g = build({{Sphere{}, {Transform::scale({3, 1, 0.5})}}});
    expect_hit(*g, {10, 0, 0}, {-1, 0, 0}, 7, {1, 0, 0});
    expect_hit(*g, {0, 0, 0}, {0, 0, -1}, 0.5, {0, 0, -1});
    const Real y = std::sqrt(0.75);
    expect_hit(*g, {1.5, 5, 0}, {0, -1, 0}, 5 - y, normalize({1.5 / 9, y, 0}));
}

TEST(Intersection, Plane) {
    const auto g = build({{Plane{{0, 2, 0}, {0, 5, 0}}}});
    expect_hit(*g, {3, 4, 0}, {0, -1, 0}, 2, {0, 1, 0});
    expect_hit(*g, {3, 4, 0}, {1, -1, 0}, 2 * std::sqrt(2.0), {0, 1, 0});
    expect_hit(*g, {3, 0, 0}, {0, 1, 0}, 2, {0, 1, 0});  // the normal is along `normal`
    EXPECT_FALSE(shoot(*g, {3, 4, 0}, {0, 1, 0}));
    EXPECT_FALSE(shoot(*g, {3, 4, 0}, {1, 0, 0}));
}

TEST(Intersection, Disk) {
    const auto g = build({{Disk{{1, 2, 3}, {0, 3, 0}, 2}}});
    expect_hit(*g, {1, 5, 3}, {0, -1, 0}, 3, {0, 1, 0});
    expect_hit(*g, {1, 1, 3}, {0, 1, 0}, 1, {0, 1, 0});
    EXPECT_TRUE(shoot(*g, {1, 5, 5 - 1e-9}, {0, -1, 0}));
    EXPECT_FALSE(shoot(*g, {1, 5, 5 + 1e-9}, {0, -1, 0}));
    EXPECT_FALSE(shoot(*g, {-5, 2, 3}, {1, 0, 0}));  // edge on
}

TEST(Intersection, Box) {
    const auto g = build({{Box{{1, 2, 3}, {3, 6, 4}}}});
    expect_hit(*g, {0, 3, 3.5}, {1, 0, 0}, 1, {-1, 0, 0});
    expect_hit(*g, {2, 3, 3.5}, {1, 0, 0}, 1, {1, 0, 0});
    expect_hit(*g, {2, 9, 3.5}, {0, -1, 0}, 3, {0, 1, 0});
    expect_hit(*g, {2, 3, 0}, {0, 0, 1}, 3, {0, 0, -1});
    expect_hit(*g, {0, 3, 2.5}, {1, 0, 1}, std::sqrt(2.0), {-1, 0, 0});
    EXPECT_FALSE(shoot(*g, {0, 6 + 1e-9, 3.5}, {1, 0, 0}));
    EXPECT_TRUE(shoot(*g, {0, 6 - 1e-9, 3.5}, {1, 0, 0}));
}

TEST(Intersection, Cylinder) {
    const auto g = build({{Cylinder{{0, 0, 1}, {0, 0, 5}, 2}}});
    expect_hit(*g, {10, 0, 2}, {-1, 0, 0}, 8, {1, 0, 0});
    expect_hit(*g, {0, 0, 2}, {0, 1, 0}, 2, {0, 1, 0});
    expect_hit(*g, {1, 1, 9}, {0, 0, -1}, 4, {0, 0, 1});
    expect_hit(*g, {1, 1, 2}, {0, 0, -1}, 1, {0, 0, -1});
    // In through the side at (2, 0, 3), out through the cap: over half the height at 45 degrees.
    expect_hit(*g, {4, 0, 1}, {-1, 0, 1}, 2 * std::sqrt(2.0), {1, 0, 0});
    expect_hit(*g, {1.9, 0, 3.1}, {-1, 0, 1}, 1.9 * std::sqrt(2.0), {0, 0, 1});
    EXPECT_FALSE(shoot(*g, {10, 0, 5 + 1e-9}, {-1, 0, 0}));
    EXPECT_FALSE(shoot(*g, {10, 2 + 1e-9, 2}, {-1, 0, 0}));
}

// A fibre a hundred million times longer than thick, along no axis.
TEST(Intersection, CylinderLikeAFibre) {
    const Vec3 axis = normalize({1, 2, 3});
    const Vec3 across = normalize(cross(axis, {0, 0, 1}));
    const auto g = build({{Cylinder{-100 * axis, 100 * axis, 1e-6}}});
    const auto hit = shoot(*g, 3 * across + 20 * axis, -across);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 3 - 1e-6, 1e-12);
    expect_near(hit->ng, across, 1e-6);
}

TEST(Intersection, MeshCube) {
    const auto g = build({{test::cube()}});
    expect_hit(*g, {0.3, 0.2, 5}, {0, 0, -1}, 4, {0, 0, 1});
    expect_hit(*g, {0, 0, 0}, {1, 0, 0}, 1, {1, 0, 0});
    expect_hit(*g, {0.1, 0.2, 0.3}, {0, -1, 0}, 1.2, {0, -1, 0});
    EXPECT_EQ(g->num_triangles(), 12U);
}

// A quarter turn about z takes the face +x to +y; twice as high and moved by 10 along z.
TEST(Intersection, ShapesUnderATransform) {
    const Transform m = Transform::translate({0, 0, 10}) * Transform::rotate({0, 0, 1}, kPi / 2) *
                        Transform::scale({2, 1, 1});
    for (const Shape& cube : {Shape{Box{{-1, -1, -1}, {1, 1, 1}}}, Shape{test::cube()}}) {
        const auto g = build({{cube, {m}}});
        expect_hit(*g, {0.5, 5, 10.25}, {0, -1, 0}, 3, {0, 1, 0});
        expect_hit(*g, {5, 1.5, 10.25}, {-1, 0, 0}, 4, {1, 0, 0});
    }
}

// A mirror turns the order of a triangle's corners round, but not what is outside.
TEST(Intersection, NormalsPointOutwardsInAMirror) {
    const Transform mirror = Transform::scale({-1, 1, 2});
    const std::vector<Shape> shapes{test::cube(), test::icosphere(3, true), Sphere{},
                                    Box{{-1, -1, -1}, {1, 1, 1}}, Cylinder{{0, -1, 0}, {0, 1, 0}}};
    test::Random random(1);
    for (const Shape& shape : shapes) {
        const auto g = build({{shape, {mirror}}});
        for (int i = 0; i < 1000; ++i) {
            const Vec3 d = random.direction();
            const auto from_inside = shoot(*g, {0, 0, 0}, d);
            ASSERT_TRUE(from_inside);
            EXPECT_GT(dot(from_inside->ng, d), 0);
            EXPECT_GT(dot(from_inside->ns, d), 0);
            const auto from_outside = shoot(*g, 5 * d, -d);
            ASSERT_TRUE(from_outside);
            EXPECT_GT(dot(from_outside->ng, d), 0);
        }
    }
}

// A plane and a disk keep their normals' side under a mirror: y = 1 becomes y = -1, up becomes
// down.
TEST(Intersection, NormalsOfOpenShapesFollowTheTransform) {
    const Transform mirror = Transform::scale({1, -1, 1});
    for (const Shape& shape : {Shape{Plane{{0, 1, 0}}}, Shape{Disk{{0, 1, 0}}}}) {
        const auto g = build({{shape, {mirror}}});
        expect_hit(*g, {0, 5, 0}, {0, -1, 0}, 6, {0, -1, 0});
    }
}

// The smooth icosphere's normals are those of the sphere; under a scale, those of the ellipsoid.
TEST(Intersection, ShadingNormalsAreInterpolated) {
    const auto sphere = build({{test::icosphere(4, true)}});
    const auto ellipsoid = build({{test::icosphere(4, true), {Transform::scale({3, 1, 0.5})}}});
    test::Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 d = random.direction();
        expect_near(shoot(*sphere, {}, d)->ns, d, 2e-3);
        const auto hit = shoot(*ellipsoid, {}, d);
        expect_near(hit->ns, normalize({hit->p.x / 9, hit->p.y, 4 * hit->p.z}), 1e-2);
    }
}

// Normals that a file has the wrong way round are turned to the side of the geometric normal.
TEST(Intersection, ShadingNormalsAreOnTheGeometricSide) {
    TriangleMesh mesh = *test::icosphere(3, true);
    for (Vec3& n : mesh.normals) n = -n;
    const auto g = build({{std::make_shared<const TriangleMesh>(std::move(mesh))}});
    test::Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 d = random.direction();
        expect_near(shoot(*g, {}, d)->ns, d, 1e-2);
    }
}

TEST(Intersection, GivesSurfaceCoordinatesOfMeshes) {
    const auto square = build({{test::square(2)}});
    const auto hit = square->intersect({{1, -1, 3}, {0, 0, -1}});
    ASSERT_TRUE(hit);
    const Vec2 uv = square->surface_uv(*hit);
    EXPECT_NEAR(uv.x, 0.75, 1e-6);
    EXPECT_NEAR(uv.y, 0.25, 1e-6);
}

TEST(Intersection, FindsTheNearestOfAll) {
    const auto g = build({{Plane{{0, 0, 0}, {0, 1, 0}}},
                          {Sphere{{0, 2, 0}, 1}},
                          {test::cube(), {Transform::translate({0, 6, 0})}},
                          {Plane{{0, 9, 0}, {0, -1, 0}}}});
    const auto object = [&](Vec3 from, Vec3 towards) {
        const auto hit = shoot(*g, from, towards);
        return hit ? static_cast<int>(hit->object) : -1;
    };
    EXPECT_EQ(object({0.1, 8, 0}, {0, -1, 0}), 2);
    EXPECT_EQ(object({0.1, 4, 0}, {0, -1, 0}), 1);
    EXPECT_EQ(object({0.1, 0.5, 0}, {0, -1, 0}), 0);
    EXPECT_EQ(object({0.1, 10, 0}, {0, -1, 0}), 3);
    EXPECT_EQ(object({5, 4, 0}, {0, -1, 0}), 0);
    EXPECT_EQ(object({5, 4, 0}, {0, 1, 0}), 3);
    EXPECT_EQ(object({5, 4, 0}, {1, 0, 0}), -1);
    EXPECT_EQ(object({5, 6, 0}, {-1, 0, 0}), 2);
}

TEST(Intersection, NamesObjectAndInstance) {
    const auto g = build(
        {{Sphere{}, {Transform::translate({9, 0, 0}), Transform::translate({0, 9, 0})}},
         {test::cube(), {Transform::translate({0, 0, 9}), Transform::translate({-9, 0, 0})}}});
    const auto y = shoot(*g, {}, {0, 1, 0});
    EXPECT_EQ(y->object, 0U);
    EXPECT_EQ(y->instance, 1U);
    const auto minus_x = shoot(*g, {}, {-1, 0, 0});
    EXPECT_EQ(minus_x->object, 1U);
    EXPECT_EQ(minus_x->instance, 1U);
}

TEST(Occlusion, ReachesAsFarAsItIsAsked) {
    const std::vector<Shape> at_one{Plane{{1, 0, 0}, {1, 0, 0}}, Disk{{1, 0, 0}, {1, 0, 0}},
                                    Box{{1, -1, -1}, {2, 1, 1}}, Sphere{{2, 0, 0}, 1},
                                    Cylinder{{1, 0, 0}, {2, 0, 0}}};
    for (const Shape& shape : at_one) {
        const auto g = build({{shape}});
        const Ray ray{-g->origin(), {1, 0, 0}};
        EXPECT_TRUE(g->occluded(ray, 1 + 1e-9));
        EXPECT_FALSE(g->occluded(ray, 1 - 1e-9));
        EXPECT_TRUE(g->occluded(ray, std::numeric_limits<Real>::infinity()));
        EXPECT_FALSE(g->occluded({ray.o, {-1, 0, 0}}, std::numeric_limits<Real>::infinity()));
        EXPECT_FALSE(g->occluded(ray, 0));
        EXPECT_FALSE(g->occluded(ray, -1));
        EXPECT_FALSE(g->occluded(ray, std::nan("")));
    }
    const auto mesh = build({{test::cube(), {Transform::translate({2, 0, 0})}}});
    EXPECT_TRUE(mesh->occluded({-mesh->origin(), {1, 0, 0}}, 1 + 1e-6));
    EXPECT_FALSE(mesh->occluded({-mesh->origin(), {1, 0, 0}}, 1 - 1e-6));
}

TEST(Intersection, RaysThatAreNotFiniteHitNothing) {
    const auto g = build({{Sphere{}}, {test::cube()}, {Plane{}}});
    const Real inf = std::numeric_limits<Real>::infinity();
    for (const Real bad : {inf, -inf, std::nan("")}) {
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 v{0, 3, 0};
            (axis == 0 ? v.x : axis == 1 ? v.y : v.z) = bad;
            EXPECT_FALSE(g->intersect({v, {0, -1, 0}}));
            EXPECT_FALSE(g->intersect({{0, 3, 0}, v}));
            EXPECT_FALSE(g->occluded({v, {0, -1, 0}}, inf));
            EXPECT_FALSE(g->occluded({{0, 3, 0}, v}, inf));
        }
    }
    EXPECT_FALSE(g->intersect({{inf, -inf, 0}, {0, -1, 0}}));
    EXPECT_FALSE(g->intersect({{0, 3, 0}, {0, 0, 0}}));
}

// A ray from a thousand million radii away still meets what it is aimed at.
TEST(Intersection, RaysFromFarAway) {
    for (const Shape& shape : {Shape{Sphere{}}, Shape{test::cube()}}) {
        const auto g = build({{shape}});
        const auto hit = g->intersect({{1e9, 0.25, 0.25}, {-1, 0, 0}});
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->p.y, 0.25, 1e-6);
        EXPECT_TRUE(g->occluded({{1e9, 0.25, 0.25}, {-1, 0, 0}}, 1e9));
        EXPECT_FALSE(g->occluded({{1e9, 0.25, 0.25}, {-1, 0, 0}}, 1e9 - 10));
        EXPECT_FALSE(g->intersect({{1e9, 0.25, 0.25}, {1, 0, 0}}));
        EXPECT_FALSE(g->intersect({{1e9, 2, 0.25}, {-1, 0, 0}}));
    }
}

}  // namespace
}  // namespace bouguer::renderer
