// SPDX-License-Identifier: Apache-2.0
// A mesh is met as precisely beside something huge, or far away, as alone; instances too.
#include <limits>

#include "tests/renderer/geometry/geometry_testing.h"
#include "tests/support/meshes.h"

namespace bouguer::renderer {
namespace {

using test::build;

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

/// Two geometries that hold the same object 0, of which the second holds more, out of the way.
void expect_same(const Geometry& alone, const Geometry& among, Vec3 middle, Real size,
                 Real tolerance) {
    test::Random random(11);
    std::vector<Hit> crossings_alone, crossings_among;
    int met = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 from = middle + 3 * size * random.direction();
        const Vec3 d = normalize(middle + random.in_cube(size) - from);
        const Ray ray_alone{from - alone.origin(), d}, ray_among{from - among.origin(), d};
        const auto a = alone.intersect(ray_alone), b = among.intersect_within(ray_among, 6 * size);
        ASSERT_EQ(a.has_value(), b.has_value()) << i;
        alone.crossings(ray_alone, 0, 6 * size, crossings_alone);
        among.crossings(ray_among, 0, 6 * size, crossings_among);
        ASSERT_EQ(crossings_alone.size(), crossings_among.size()) << i;
        if (!a) continue;
        ++met;
        ASSERT_EQ(b->object, 0U);
        ASSERT_EQ(b->instance, a->instance);
        ASSERT_EQ(b->primitive, a->primitive);
        const Real along = tolerance / std::abs(dot(a->ng, d));
        ASSERT_NEAR(b->t, a->t, along);
        ASSERT_LE(length(b->p + among.origin() - a->p - alone.origin()), along);
        ASSERT_LE(length(b->ng - a->ng), 1e-12);
        const Real resolution = resolution_along(*b, d);
        ASSERT_LE(b->resolution, 1e3 * tolerance);
        ASSERT_TRUE(among.occluded(ray_among, b->t + 2 * resolution));
        ASSERT_FALSE(among.occluded(ray_among, b->t - 2 * resolution));
    }
    EXPECT_GT(met, 500);
}

std::vector<PlacedShape> small_mesh(Vec3 at, Real size) {
    return {
        {test::icosphere(3), {Transform::translate(at) * Transform::scale({size, size, size})}}};
}

TEST(NestedMeshes, BesideAPlanetAreAsPreciseAsAlone) {
    const Vec3 at{0.3, 0.1, -0.2};
    auto shapes = small_mesh(at, 0.01);
    const auto alone = build(shapes);
    shapes.push_back({Sphere{{0, -6.4e6, 0}, 6.4e6 - 1}});
    expect_same(*alone, *build(shapes), at, 0.01, 2e-8);
}

TEST(NestedMeshes, FarFromEachOtherAreAsPreciseAsAlone) {
    const Vec3 at{3e5, -2e5, 1e5};
    auto shapes = small_mesh(at, 0.5);
    const auto alone = build(shapes);
    shapes.push_back({test::cube(), {Transform::translate(-at)}});
    expect_same(*alone, *build(shapes), at, 0.5, 1e-9);
}

// Those that share one Embree scene, under every kind of transform.
TEST(NestedMeshes, InstancesBesideSomethingHugeAreAsPreciseAsAlone) {
    const Transform small = Transform::scale({0.02, 0.02, 0.02});
    const Vec3 at{1, 2, 3};
    const std::vector<Transform> places{
        Transform::translate(at) * small,
        Transform::translate(at + Vec3{0.03, 0, 0}) * Transform::rotate({1, 2, 3}, 1) * small *
            Transform::scale({0.3, 1, 0.7}),
        Transform::translate(at - Vec3{0.03, 0.01, 0}) * small * Transform::scale({-1, 0.5, 1})};
    const std::vector<PlacedShape> shapes{{test::icosphere(3), places}};
    const auto alone = build(shapes);
    auto with_planet = shapes;
    with_planet.push_back({Sphere{{0, -1e5, 0}, 1e5 - 1}});
    expect_same(*alone, *build(with_planet), at, 0.05, 1e-9);
    GeometryOptions no_copies;
    no_copies.max_baked_triangles = 0;
    expect_same(*alone, *build(shapes, no_copies), at, 0.05, 1e-12);
    expect_same(*alone, *build(with_planet, no_copies), at, 0.05, 1e-9);
}

// A pane of glass, a ten-millionth of the scene thick: both of its sides, in their order.
TEST(NestedMeshes, HaveTwoSidesHoweverThinTheyAre) {
    const Transform pane = Transform::translate({0.1, 0.2, 5}) * Transform::scale({1, 1, 5e-6});
    const auto g = build({{test::cube(), {pane}}, {Sphere{{0, -200, 0}, 100}}});
    test::Random random(12);
    std::vector<Hit> all;
    for (int i = 0; i < 1000; ++i) {
        const Vec3 from{random.between(-0.8, 1), random.between(-0.7, 1.1), 8};
        const Vec3 d = normalize({random.between(-0.01, 0.01), random.between(-0.01, 0.01), -1});
        g->crossings({from - g->origin(), d}, 0, kInfinity, all);
        ASSERT_EQ(all.size(), 2U);
        ASSERT_LT(dot(all[0].ng, d), 0);
        ASSERT_GT(dot(all[1].ng, d), 0);
        ASSERT_NEAR((all[1].t - all[0].t) * -d.z, 1e-5, 1e-10);
        ASSERT_GT(all[1].t - all[0].t, all[0].resolution + all[1].resolution);
    }
}

TEST(NestedMeshes, KnowWhatIsInside) {
    const Vec3 at{4e4, 0, 2e4};
    const auto g = build({{test::torus(1, 0.3, 40, 20), {Transform::translate(at)}},
                          {test::cube(), {Transform::translate(-at)}}});
    test::Random random(13);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 q = random.in_cube(1.4);
        const Real from_ring = std::hypot(std::hypot(q.x, q.y) - 1, q.z);
        if (from_ring > 0.28 && from_ring < 0.301) continue;  // facets
        EXPECT_EQ(g->contains(0, 0, at + q - g->origin()), from_ring < 0.29);
    }
}

}  // namespace
}  // namespace bouguer::renderer
