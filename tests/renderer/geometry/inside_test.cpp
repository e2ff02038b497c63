// SPDX-License-Identifier: Apache-2.0
// What is inside of shapes, and how near their surfaces come.
#include <functional>

#include "tests/renderer/geometry/geometry_testing.h"
#include "tests/support/meshes.h"

namespace bouguer::renderer {
namespace {

using test::build;

/// A shape and how far a point is from its surface, about: negative inside.
struct Solid {
    const char* what;
    Shape shape;
    std::function<Real(Vec3)> distance;
    Real facets = 0;  ///< how far the surface may be off
};

std::vector<Solid> solids() {
    const auto cube = [](Vec3 p) { return max_abs(p) - 1; };
    return {
        {"sphere", Sphere{{0.5, 0, 0}, 1},
         [](Vec3 p) {
             return length(p - Vec3{0.5, 0, 0}) - 1;
         }},
        {"box", Box{{-1, -1, -1}, {1, 1, 1}}, cube},
        {"cylinder", Cylinder{{0, -1, 0}, {0, 1, 0}, 0.8},
         [](Vec3 p) { return std::max(std::hypot(p.x, p.z) - 0.8, std::abs(p.y) - 1); }},
        {"plane", Plane{{0, 0.3, 0}, {0, 2, 0}}, [](Vec3 p) { return p.y - 0.3; }},
        {"mesh", test::cube(), cube},
        {"torus", test::torus(1, 0.4, 64, 32),
         [](Vec3 p) { return std::hypot(std::hypot(p.x, p.y) - 1, p.z) - 0.4; }, 0.01},
    };
}

std::vector<Transform> places() {
    return {Transform{},
            Transform::translate({40, -30, 20}) * Transform::rotate({1, 2, 3}, 1) *
                Transform::scale({2, 0.5, 1}),
            Transform::scale({-1, 1, 3})};
}

/// Asks about random points of every solid under every transform, as one of several instances.
void for_all(
    const std::function<void(const Geometry&, std::uint32_t instance, Vec3 p, Real)>& ask) {
    for (const Solid& solid : solids()) {
        SCOPED_TRACE(solid.what);
        const auto g = build({{Disk{{0, 5, 0}}}, {solid.shape, places()}});
        test::Random random(31);
        for (std::uint32_t i = 0; i < places().size(); ++i) {
            for (int k = 0; k < 500; ++k) {
                const Vec3 q = random.in_cube(1.6);
                const Real distance = solid.distance(q);
                if (std::abs(distance) <= solid.facets + 1e-6) continue;
                ask(*g, i, places()[i].point(q) - g->origin(), distance);
                if (testing::Test::HasFailure()) return;
            }
        }
    }
}

TEST(Contains, WhatIsInsideOfEveryInstance) {
    for_all([](const Geometry& g, std::uint32_t instance, Vec3 p, Real distance) {
        EXPECT_EQ(g.contains(1, instance, p), distance < 0) << instance << " " << distance;
    });
}

TEST(Contains, NothingInADisk) {
    const auto g = build({{Disk{{}, {0, 1, 0}, 1}}});
    for (const Real y : {-0.5, -1e-9, 0.0, 1e-9, 0.5}) EXPECT_FALSE(g->contains(0, 0, {0, y, 0}));
}

TEST(Contains, WhatIsBehindAPlaneHoweverFar) {
    const auto g = build({{Plane{{0, 1, 0}, {0, 1, 0}}}, {Sphere{}}});
    EXPECT_TRUE(g->contains(0, 0, Vec3{1e30, -1e30, 0}));
    EXPECT_TRUE(g->contains(0, 0, Vec3{0, 1 - 1e-9, 0}));
    EXPECT_FALSE(g->contains(0, 0, Vec3{0, 1 + 1e-9, 0}));
    EXPECT_FALSE(g->contains(0, 0, Vec3{-1e30, 1e30, 0}));
}

// A point that is on the surface is touched by any reach; one that is off, by no less than that.
TEST(Touches, WhatComesNear) {
    for (const Solid& solid : solids()) {
        SCOPED_TRACE(solid.what);
        const auto g = build({{solid.shape}});
        test::Random random(32);
        for (int k = 0; k < 500; ++k) {
            const auto hit = g->intersect({random.in_cube(0.3) - g->origin(), random.direction()});
            if (!hit) continue;
            ASSERT_TRUE(g->touches(0, 0, hit->p, 1e-9));
            ASSERT_TRUE(g->touches(0, 0, hit->p + 0.01 * hit->ng, 0.011));
            if (!std::holds_alternative<std::shared_ptr<const TriangleMesh>>(solid.shape)) {
                ASSERT_FALSE(g->touches(0, 0, hit->p + 0.01 * hit->ng, 0.002));
            }
        }
    }
}

TEST(Touches, NotAMeshThatIsAway) {
    const auto g = build({{test::cube(), {Transform::translate({5, 0, 0})}}});
    const Vec3 p = Vec3{5, 0, 0} - g->origin();
    EXPECT_FALSE(g->touches(0, 0, p + Vec3{3, 0, 0}, 0.5));
    EXPECT_TRUE(g->touches(0, 0, p + Vec3{3, 0, 0}, 2.5));
}

TEST(Reach, CoversTheErrorOfAHit) {
    const auto mixed = build({{Sphere{}}, {test::cube(), {Transform::translate({9, 0, 0})}}});
    const auto shapes = build({{Sphere{}}, {Box{{8, -1, -1}, {10, 1, 1}}}});
    for (const Geometry* g : {mixed.get(), shapes.get()}) {
        for (const Real x : {0.0, 9.0}) {
            const auto hit = g->intersect({Vec3{x, 0.1, 5} - g->origin(), {0, 0, -1}});
            ASSERT_TRUE(hit);
            EXPECT_GE(g->reach(*hit), hit->error);
            EXPECT_GE(hit->error, hit->resolution);
            EXPECT_LT(g->reach(*hit), 1e-4);
        }
    }
    const auto hit = shapes->intersect({Vec3{0, 0.1, 5} - shapes->origin(), {0, 0, -1}});
    EXPECT_LT(shapes->reach(*hit), 1e-10) << "there is no single precision where there is no mesh";
}

TEST(IsThin, WhatHasTwoSidesThatQueriesConfuse) {
    const Transform film = Transform::translate({9, 0, 0}) * Transform::scale({1, 1, 1e-7});
    const auto g = build({{test::cube()}, {test::cube(), {film}}, {Sphere{}}, {Plane{}}});
    EXPECT_FALSE(g->is_thin(0, 0));
    EXPECT_TRUE(g->is_thin(1, 0));
    EXPECT_FALSE(g->is_thin(2, 0));
    EXPECT_FALSE(g->is_thin(3, 0));
}

}  // namespace
}  // namespace bouguer::renderer
