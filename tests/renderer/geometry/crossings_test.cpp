// SPDX-License-Identifier: Apache-2.0
// All surfaces along a line: which, in what order, and which way they are crossed.
#include <array>
#include <limits>
#include <string>

#include "tests/renderer/geometry/geometry_testing.h"
#include "tests/support/meshes.h"

namespace bouguer::renderer {
namespace {

using test::build;

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
constexpr Real kBehind = -1000;

std::vector<Hit> crossings(const Geometry& g, Vec3 from, Vec3 towards, Real lo = kBehind,
                           Real hi = kInfinity) {
    std::vector<Hit> all{Hit{}, Hit{}, Hit{}};  // is replaced
    g.crossings({from - g.origin(), normalize(towards)}, lo, hi, all);
    return all;
}

/// "+0" for each surface of object 0 that is entered, "-0" for one that is left.
std::string story(const std::vector<Hit>& all, Vec3 d) {
    std::string text;
    for (const Hit& hit : all) {
        text += dot(hit.ng, d) < 0 ? '+' : '-';
        text += std::to_string(hit.object);
    }
    return text;
}

const std::vector<Shape>& closed_shapes() {
    static const std::vector<Shape> all{Sphere{}, Box{{-1, -1, -1}, {1, 1, 1}},
                                        Cylinder{{0, 0, -1}, {0, 0, 1}, 1}, test::cube(),
                                        test::icosphere(3)};
    return all;
}

TEST(Crossings, OfAConvexShapeAreInAndOut) {
    const Transform m = Transform::translate({5, -3, 2}) * Transform::rotate({1, 1, 0}, 0.7) *
                        Transform::scale({1, -2, 0.5});
    for (const Shape& shape : closed_shapes()) {
        const auto g = build({{shape, {m}}});
        test::Random random(21);
        for (int i = 0; i < 500; ++i) {
            const Vec3 inside = m.point(random.in_cube(0.5));
            const Vec3 d = random.direction();
            const auto all = crossings(*g, inside, d);
            ASSERT_EQ(story(all, d), "+0-0");
            ASSERT_LT(all[0].t, 0) << "also behind the ray's origin";
            ASSERT_GT(all[1].t, 0);
            const auto hit = g->intersect({inside - g->origin(), d});
            ASSERT_TRUE(hit);
            ASSERT_NEAR(all[1].t, hit->t, 1e-14);
            ASSERT_EQ(story(crossings(*g, inside, d, 0), d), "-0");
            ASSERT_EQ(story(crossings(*g, inside, d, kBehind, 0), d), "+0");
        }
    }
}

TEST(Crossings, OfOpenShapesAreOne) {
    for (const Shape& shape : {Shape{Plane{{}, {0, 1, 0}}}, Shape{Disk{{}, {0, 1, 0}, 2}}}) {
        const auto g = build({{shape}});
        EXPECT_EQ(story(crossings(*g, {0, 3, 0}, {0, -1, 0}), {0, -1, 0}), "+0");
        EXPECT_EQ(story(crossings(*g, {0, 3, 0}, {0, 1, 0}), {0, 1, 0}), "-0") << "behind";
        EXPECT_EQ(story(crossings(*g, {0, 3, 0}, {0, 1, 0}, 0), {0, 1, 0}), "");
        EXPECT_EQ(story(crossings(*g, {0, 3, 0}, {1, 0, 0}), {1, 0, 0}), "");
    }
}

// Both ends belong to the interval.
TEST(Crossings, AreThoseBetweenTwoDistances) {
    const auto g = build({{Plane{{0, 1, 0}, {0, 1, 0}}},
                          {Plane{{0, 2, 0}, {0, 1, 0}}},
                          {Plane{{0, 4, 0}, {0, 1, 0}}}});
    const auto objects = [&](Real lo, Real hi) {
        return story(crossings(*g, {}, {0, 1, 0}, lo, hi), {0, 1, 0});
    };
    EXPECT_EQ(objects(1, 4), "-0-1-2");
    EXPECT_EQ(objects(1 + 1e-9, 4 - 1e-9), "-1");
    EXPECT_EQ(objects(4, 4), "-2");
    EXPECT_EQ(objects(4, 1), "");
}

// Bodies in each other, beside each other and in one place, of every kind.
TEST(Crossings, ComeInOrder) {
    const auto g = build({{test::cube(), {Transform::translate({4, 0, 0})}},
                          {Sphere{{4, 0, 0}, 0.5}},
                          {Box{{-1, -1, -1}, {1, 1, 1}}},
                          {Box{{1, -1, -1}, {3, 1, 1}}},
                          {Disk{{2, 0, 0}, {-1, 0, 0}, 1}},
                          {test::cube(), {Transform::translate({8, 0, 0})}},
                          {Plane{{9, 0, 0}, {-1, 0, 0}}}});
    const auto all = crossings(*g, {-9, 0.1, 0.2}, {1, 0, 0});
    EXPECT_EQ(story(all, {1, 0, 0}), "+2-2+3+4+0-3+1-1-0+5-5+6");
    const std::array t{8, 10, 10, 11, 12, 12, 0, 0, 14, 16, 18, 18};
    ASSERT_EQ(all.size(), t.size());
    for (std::size_t i = 0; i < t.size(); ++i) {
        if (t[i] != 0) {
            EXPECT_NEAR(all[i].t, t[i], 1e-12) << i;
        }
    }
}

TEST(Crossings, NameTheInstance) {
    const std::vector<Transform> places{
        Transform::translate({6, 0, 0}), {}, Transform::translate({3, 0, 0})};
    for (const Shape& shape : closed_shapes()) {
        for (const std::uint64_t copies : {0U, 1000000U}) {
            GeometryOptions options;
            options.max_baked_triangles = copies;
            const auto all =
                crossings(*build({{shape, places}}, options), {-9, 0.1, 0.2}, {1, 0, 0});
            ASSERT_EQ(all.size(), 6U);
            const std::array<std::uint32_t, 6> order{1, 1, 2, 2, 0, 0};
            for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(all[i].instance, order[i]);
        }
    }
}

// A line through what triangles share meets one surface, not two.
TEST(Crossings, OfAMeshCountAnEdgeOrCornerOnce) {
    for (const bool is_nested : {false, true}) {
        std::vector<PlacedShape> shapes{{test::cube()}};
        if (is_nested) shapes.push_back({Sphere{{0, -3000, 0}, 1000}});
        const auto g = build(shapes);
        test::Random random(22);
        std::vector<Vec3> shared{{0, 0, 1}, {0, 0, -1}, {1, 1, 1}, {-1, 1, 1}, {0, 1, 1}};
        for (int i = 0; i < 200; ++i) {
            const Real a = random.between(-1, 1);
            shared.push_back({a, a, 1});  // one of the two is the diagonal of a face
            shared.push_back({a, -a, -1});
            shared.push_back({1, a, 1});  // edges of the cube
            shared.push_back({-1, 1, a});
        }
        for (const Vec3 on : shared) {
            // From the middle of the cube, so that the line leaves it there.
            const auto out = crossings(*g, {0.01, 0.02, 0.03}, on - Vec3{0.01, 0.02, 0.03}, 0);
            ASSERT_EQ(story(out, on - Vec3{0.01, 0.02, 0.03}), "-0")
                << on.x << " " << on.y << " " << on.z;
        }
    }
}

// What cuts through its own surface is crossed as often as it is there.
TEST(Crossings, OfAMeshAreAll) {
    const auto g = build({{test::torus(1, 0.25, 64, 32)}});
    EXPECT_EQ(story(crossings(*g, {-5, 0.01, 0.02}, {1, 0, 0}), {1, 0, 0}), "+0-0+0-0");
    EXPECT_EQ(story(crossings(*g, {0.01, 0.02, -5}, {0, 0, 1}), {0, 0, 1}), "");
}

TEST(Crossings, OfRaysThatAreNotFiniteAreNone) {
    const auto g = build({{Sphere{}}, {test::cube()}, {Plane{}}});
    const Real nan = std::nan("");
    std::vector<Hit> all{Hit{}};
    g->crossings({{nan, 0, 0}, {0, 1, 0}}, 0, 1, all);
    EXPECT_TRUE(all.empty());
    g->crossings({{}, {0, 1, 0}}, nan, 1, all);
    EXPECT_TRUE(all.empty());
}

}  // namespace
}  // namespace bouguer::renderer
