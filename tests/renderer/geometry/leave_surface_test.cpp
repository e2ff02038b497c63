// SPDX-License-Identifier: Apache-2.0
// Rays that leave a surface do not meet it again, and skip nothing that lies close by.
#include "tests/renderer/geometry/geometry_testing.h"
#include "tests/support/meshes.h"

namespace bouguer::renderer {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

/// Closed convex bodies of about unit size about zero.
std::vector<Shape> convex_bodies() {
    return {Sphere{}, Box{{-1, -0.5, -2}, {1, 0.5, 2}}, Cylinder{{0, -1, 0}, {0, 1, 0}, 0.5},
            test::cube(), test::icosphere(3)};
}

/// `shape` of size `scale` with its middle at `offset`.
PlacedShape placed(const Shape& shape, Real scale, Vec3 offset) {
    return {shape,
            {Transform::translate(offset) * Transform::rotate({1, 2, 3}, 0.7) *
             Transform::scale(Vec3{1, 1, 1} * scale)}};
}

/// A random unit vector on `n`'s side, in one case of four nearly along the surface.
Vec3 away_from(Vec3 n, test::Random& random) {
    Vec3 d = random.direction();
    if (dot(d, n) < 0) d = -d;
    if (random.uniform() < 0.25)
        d = normalize(d - (1 - random.between(1e-6, 1e-3)) * dot(d, n) * n);
    return d;
}

/// Of rays that leave `geometry`'s only body, which is convex: those that meet it again.
int count_returns(const Geometry& geometry, Real size, int rays, std::uint64_t seed) {
    test::Random random(seed);
    int returns = 0;
    for (int i = 0; i < rays; ++i) {
        const Vec3 target = random.in_cube(0.25 * size);
        const Vec3 d = random.direction();
        const auto hit = geometry.intersect({target - (4 * size) * d, d});
        EXPECT_TRUE(hit);
        if (!hit) continue;
        const Vec3 out = away_from(hit->ng, random);
        const Ray ray{leave_surface(*hit, out), out};
        if (geometry.intersect(ray) || geometry.occluded(ray, kInfinity)) ++returns;
    }
    return returns;
}

/// Of rays that go into a convex body: those that do not come out of it again, or meet first what
/// they have just passed.
int count_lost_inside(const Geometry& geometry, Real size, int rays, std::uint64_t seed) {
    test::Random random(seed);
    int lost = 0;
    for (int i = 0; i < rays; ++i) {
        const Vec3 target = random.in_cube(0.25 * size);
        const Vec3 d = random.direction();
        const auto entry = geometry.intersect({target - (4 * size) * d, d});
        if (!entry) continue;
        const Ray inside{leave_surface(*entry, d), d};
        const auto exit = geometry.intersect(inside);
        if (!exit || dot(exit->ng, d) <= 0 || exit->t < 0.01 * size) ++lost;
    }
    return lost;
}

TEST(LeaveSurface, DoesNotMeetTheSurfaceAgainAtAnyScale) {
    for (const Shape& shape : convex_bodies()) {
        for (const Real scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
            const auto g = test::build({placed(shape, scale, {})});
            EXPECT_EQ(count_returns(*g, scale, 4000, shape.index()), 0)
                << "shape " << shape.index() << ", scale " << scale;
            EXPECT_EQ(count_lost_inside(*g, scale, 2000, shape.index()), 0)
                << "shape " << shape.index() << ", scale " << scale;
        }
    }
}

TEST(LeaveSurface, DoesNotMeetTheSurfaceAgainFarFromZero) {
    for (const Shape& shape : convex_bodies()) {
        for (const Real offset : {1e5, 1e6}) {
            const auto g = test::build({placed(shape, 1, {offset, -offset, offset / 3})});
            EXPECT_EQ(count_returns(*g, 1, 4000, shape.index()), 0)
                << "shape " << shape.index() << ", offset " << offset;
            EXPECT_EQ(count_lost_inside(*g, 1, 2000, shape.index()), 0)
                << "shape " << shape.index() << ", offset " << offset;
        }
    }
}

// A small body in the corner of a large scene, where single precision is coarse.
TEST(LeaveSurface, DoesNotMeetTheSurfaceAgainInALargeScene) {
    for (const Shape& shape : convex_bodies()) {
        const Vec3 corner{900, -800, 700};
        const auto g = test::build({placed(shape, 1, corner), {Sphere{-corner, 1}}});
        test::Random random(3);
        int returns = 0;
        for (int i = 0; i < 4000; ++i) {
            const Vec3 d = random.direction();
            const auto hit =
                g->intersect({corner - g->origin() + random.in_cube(0.25) - 4.0 * d, d});
            ASSERT_TRUE(hit);
            const Vec3 out = away_from(hit->ng, random);
            const auto again = g->intersect({leave_surface(*hit, out), out});
            if (again && again->object == 0) ++returns;
        }
        EXPECT_EQ(returns, 0) << "shape " << shape.index();
    }
}

// Where the coordinates are small, rays round little, but the corners of a large triangle are far.
TEST(LeaveSurface, DoesNotMeetALargeTriangleAgainNearTheOrigin) {
    const auto g = test::build({{test::square(1000), {Transform::rotate({1, 2, 3}, 0.7)}}});
    test::Random random(6);
    int returns = 0;
    for (int i = 0; i < 10000; ++i) {
        const Vec3 d = random.direction();
        const auto hit = g->intersect({random.in_cube(1e-2) - 1.0 * d, d});
        if (!hit) continue;
        const Vec3 out = away_from(i % 2 == 0 ? hit->ng : -hit->ng, random);
        if (g->intersect({leave_surface(*hit, out), out})) ++returns;
        if (g->occluded({leave_surface(*hit, out), out}, kInfinity)) ++returns;
    }
    EXPECT_EQ(returns, 0);
}

// Instances go through a transform that Embree inverts in single precision.
TEST(LeaveSurface, DoesNotMeetAnInstanceAgain) {
    const Transform m = Transform::rotate({1, 2, 3}, 0.7) * Transform::scale({1, 0.2, 3});
    const auto ball = test::icosphere(3);
    const std::vector<Transform> places{Transform::translate({-5, 0, 0}) * m,
                                        Transform::translate({50, 20, 0}) * m};
    const auto g = test::build({{ball, places}}, {.max_baked_triangles = 0});
    test::Random random(4);
    int returns = 0;
    for (int i = 0; i < 10000; ++i) {
        const Vec3 middle = places[static_cast<std::size_t>(i % 2)].t - g->origin();
        const Vec3 d = random.direction();
        const auto hit = g->intersect({middle + random.in_cube(0.1) - 10.0 * d, d});
        ASSERT_TRUE(hit);
        const Vec3 out = away_from(hit->ng, random);
        const auto again = g->intersect({leave_surface(*hit, out), out});
        if (again && again->instance == hit->instance) ++returns;
    }
    EXPECT_EQ(returns, 0);
}

/// Rays from one body meet the next one, a gap away, and not what lies behind it.
void expect_gap_is_seen(const std::vector<PlacedShape>& stack, Real first_top, Real gap) {
    const auto g = test::build(stack);
    test::Random random(5);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 from{random.between(-0.9, 0.9), random.between(-0.9, 0.9), 0};
        const auto exit = test::shoot(*g, from, {0, 0, 1});
        ASSERT_TRUE(exit);
        ASSERT_EQ(exit->object, 0U);
        ASSERT_NEAR(exit->p.z, first_top, 0.01 * gap);
        const Vec3 o = leave_surface(*exit, {0, 0, 1});
        const auto next = test::shoot(*g, o, {0, 0, 1});
        ASSERT_TRUE(next);
        EXPECT_EQ(next->object, 1U);
        EXPECT_NEAR(next->p.z, first_top + gap, 0.02 * gap);
        EXPECT_LT(next->ng.z, 0);
    }
}

// Two bodies a share of the scene's size (4 units) apart: 1e-4 and less in single precision, 1e-9
// in double.
TEST(LeaveSurface, SkipsNoNearbySurface) {
    const auto mesh = test::cube();
    for (const Real gap : {4e-4, 4e-5}) {
        expect_gap_is_seen({{mesh}, {mesh, {Transform::translate({0, 0, 2 + gap})}}}, 1, gap);
    }
    const Box box{{-1, -1, -1}, {1, 1, 1}};
    for (const Real gap : {4e-4, 4e-7, 4e-9}) {
        expect_gap_is_seen({{box}, {box, {Transform::translate({0, 0, 2 + gap})}}}, 1, gap);
    }
}

// The offset follows the coordinates: a scene a million times larger has one a million times
// larger.
TEST(LeaveSurface, IsNoAbsoluteLength) {
    for (const Shape& shape : {Shape{Sphere{}}, Shape{test::cube()}}) {
        const auto small = test::build({{shape}});
        const auto large = test::build({{shape, {Transform::scale({1e6, 1e6, 1e6})}}});
        const Vec3 d = normalize({-3, -2, -1});
        const Real a = small->intersect({-4 * d, d})->error;
        const Real b = large->intersect({-4e6 * d, d})->error;
        EXPECT_GT(a, 0);
        EXPECT_NEAR(b / a, 1e6, 1e3);
    }
}

}  // namespace
}  // namespace bouguer::renderer
