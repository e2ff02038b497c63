// SPDX-License-Identifier: Apache-2.0
// A geometry as a whole: what is refused, and what does not change the hits.
#include "renderer/geometry/geometry.h"

#include <thread>

#include "tests/renderer/geometry/geometry_testing.h"
#include "tests/support/meshes.h"

namespace bouguer::renderer {
namespace {

using test::build;
using test::shoot;

TEST(Geometry, IsEmptyWithoutShapes) {
    const auto g = build({});
    EXPECT_FALSE(g->intersect({{}, {0, 0, 1}}));
    EXPECT_FALSE(g->occluded({{}, {0, 0, 1}}, 1e9));
    EXPECT_EQ(g->radius(), 0);
    EXPECT_EQ(g->num_triangles(), 0U);
}

// The box from (1, 2, 3) to (3, 6, 7): its middle, and half its diagonal of length 6.
TEST(Geometry, KnowsItsMiddleAndRadius) {
    const std::vector<std::vector<PlacedShape>> same_bounds{
        {{Box{{1, 2, 3}, {3, 6, 7}}}},
        {{test::cube(), {Transform::translate({2, 4, 5}) * Transform::scale({1, 2, 2})}}},
        {{Sphere{}, {Transform::translate({2, 4, 5}) * Transform::scale({1, 2, 2})}}},
        {{Box{{1, 2, 3}, {3, 6, 7}}}, {Plane{{1e9, 1e9, 1e9}}}},
        {{Disk{{1, 4, 5}, {1, 0, 0}, 2}}, {Disk{{3, 4, 5}, {1, 0, 0}, 2}}},
        {{Cylinder{{1, 4, 5}, {3, 4, 5}, 2}}}};
    for (const auto& shapes : same_bounds) {
        const auto g = build(shapes);
        test::expect_near(g->origin(), {2, 4, 5}, 1e-12);
        EXPECT_NEAR(g->radius(), 3, 1e-12);
    }
}

// Vertices that no triangle uses are not part of the scene.
TEST(Geometry, IgnoresVerticesWithoutTriangles) {
    TriangleMesh mesh = *test::cube();
    mesh.positions.push_back({1e9, 0, 0});
    const auto g = build({{std::make_shared<const TriangleMesh>(mesh)}});
    EXPECT_NEAR(g->radius(), std::sqrt(3.0), 1e-12);
}

TEST(Geometry, RefusesWhatItCannotPlace) {
    const auto refused = [](PlacedShape shape) {
        const std::vector<PlacedShape> shapes{std::move(shape)};
        const auto g = Geometry::build(shapes);
        return !g && g.error().kind == ErrorKind::InvalidInput;
    };
    const Real nan = std::nan("");
    EXPECT_TRUE(refused({Sphere{{}, 0}}));
    EXPECT_TRUE(refused({Sphere{{}, nan}}));
    EXPECT_TRUE(refused({Sphere{{nan, 0, 0}, 1}}));
    EXPECT_TRUE(refused({Sphere{}, {Transform::scale({1, 0, 1})}}));
    EXPECT_TRUE(refused({Plane{{}, {0, 0, 0}}}));
    EXPECT_TRUE(refused({Plane{{nan, 0, 0}}}));
    EXPECT_TRUE(refused({Disk{{}, {0, 0, 0}, 1}}));
    EXPECT_TRUE(refused({Box{{0, 0, 0}, {1, 0, 1}}}));
    EXPECT_TRUE(refused({Cylinder{{1, 1, 1}, {1, 1, 1}, 1}}));
    EXPECT_TRUE(refused({std::shared_ptr<const TriangleMesh>()}));
    EXPECT_TRUE(refused({std::make_shared<const TriangleMesh>()}));
    EXPECT_TRUE(refused({test::cube(), {Transform::scale({1, 1, 0})}}));
    EXPECT_TRUE(refused({test::cube(), {Transform::translate({0, nan, 0})}}));
    TriangleMesh bad = *test::cube();
    bad.triangles[3][1] = 8;
    EXPECT_TRUE(refused({std::make_shared<const TriangleMesh>(bad)}));
}

TEST(Geometry, KeepsToItsMemoryLimit) {
    const std::vector<PlacedShape> shapes{{test::icosphere(6)}};
    const auto refused = Geometry::build(shapes, {.max_memory_bytes = 1'000'000});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::TooLarge);
    const auto g = Geometry::build(shapes, {.max_memory_bytes = 100'000'000});
    ASSERT_TRUE(g);
    EXPECT_GT((*g)->memory_bytes(), 1'000'000U);
    EXPECT_LT((*g)->memory_bytes(), 100'000'000U);
}

// From inside a closed mesh every ray meets it.
TEST(Geometry, IsWatertight) {
    const auto g = build({{test::icosphere(5), {Transform::translate({1e5, 1e5, -1e5})}}});
    test::Random random(1);
    int missed = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        const Ray ray{random.in_cube(0.5), random.direction()};
        missed += g->intersect(ray) ? 0 : 1;
    }
    EXPECT_EQ(missed, 0);
}

TEST(Geometry, InstanceEqualsCopy) {
    const Transform a = Transform::translate({-3, 1, 0}) * Transform::rotate({3, 1, 2}, 1) *
                        Transform::scale({1, 0.5, -2});
    const Transform b = Transform::translate({3, 0, 1}) * Transform::scale({0.7, 0.7, 0.7});
    const std::vector<PlacedShape> shapes{{test::torus(1, 0.3, 60, 30), {a, b}}};
    const auto copies = build(shapes);
    const auto instances = build(shapes, {.max_baked_triangles = 0});
    EXPECT_EQ(copies->num_triangles(), instances->num_triangles());
    test::Random random(2);
    int hits = 0;
    int differences = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 d = random.direction();
        const Ray ray{random.in_cube(3) - 10.0 * d, d};
        const auto x = copies->intersect(ray);
        const auto y = instances->intersect(ray);
        hits += x ? 1 : 0;
        if (x.has_value() != y.has_value() || (x && std::abs(x->t - y->t) > 0.1)) {
            ++differences;  // past an edge of the silhouette
        } else if (x) {
            EXPECT_EQ(x->instance, y->instance);
            EXPECT_NEAR(x->t, y->t, 1e-5 + 1e-6 / std::abs(dot(x->ng, d)));
            EXPECT_GT(dot(x->ng, y->ng), 0.9);
            EXPECT_GT(dot(x->ns, y->ns), 0.999);
        }
    }
    EXPECT_GT(hits, 1000);
    EXPECT_LE(differences, 2);
}

std::vector<PlacedShape> mixed_scene(Vec3 at) {
    const Transform m = Transform::translate(at);
    return {{test::torus(1, 0.3, 60, 30), {m}},
            {Sphere{{0, 0, 0}, 0.5}, {m}},
            {Box{{-2, -2, -2}, {-1, 2, 2}}, {m}},
            {Cylinder{{1.5, -2, 0}, {1.5, 2, 0}, 0.2}, {m}},
            {Plane{{0, 0, -2.5}, {0, 0, 1}}, {m}}};
}

TEST(Geometry, IsTheSameFarFromZero) {
    const auto near_scene = build(mixed_scene({}));
    const auto far_scene = build(mixed_scene({1e5, -1e5, 5e4}));
    test::Random random(3);
    int differences = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 d = random.direction();
        const Ray ray{random.in_cube(1.5) - 8.0 * d, d};
        const auto x = near_scene->intersect(ray);
        const auto y = far_scene->intersect(ray);
        if (x.has_value() != y.has_value() || (x && x->object != y->object)) {
            ++differences;
        } else if (x) {
            EXPECT_NEAR(x->t, y->t, 1e-6 * std::max(1.0, x->t) / std::abs(dot(x->ng, d)));
        }
    }
    EXPECT_LE(differences, 1);
}

// The same scene in any size, from 1e-15 to 1e15 times: the same hits.
TEST(Geometry, IsTheSameAtAnyScale) {
    const auto reference = build(mixed_scene({}));
    for (const Real scale : {1e-15, 1e-6, 1e6, 1e15}) {
        auto shapes = mixed_scene({});
        for (PlacedShape& shape : shapes) {
            shape.instances[0] = Transform::scale(Vec3{1, 1, 1} * scale);
        }
        const auto scaled = build(shapes);
        test::Random random(4);
        int differences = 0;
        for (int i = 0; i < 5000; ++i) {
            const Vec3 d = random.direction();
            const Vec3 o = random.in_cube(1.5) - 8.0 * d;
            const auto x = reference->intersect({o, d});
            const auto y = scaled->intersect({scale * o, d});
            if (x.has_value() != y.has_value() || (x && x->object != y->object)) {
                ++differences;
            } else if (x) {
                EXPECT_NEAR(x->t, y->t / scale, 1e-6 * x->t / std::abs(dot(x->ng, d)));
            }
        }
        EXPECT_LE(differences, 1) << scale;
    }
}

// Single precision carries a ray over a kilometre to about 0.1 mm; a bead of a micrometre is met
// nevertheless, because the bead is intersected in double.
TEST(Geometry, TinyThingsAreMetFromAfar) {
    const Vec3 bead{700, 500, -300};
    const auto g = build({{Sphere{bead, 1e-6}}, {Sphere{-bead, 1}}});
    test::Random random(9);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 from = random.in_cube(300);
        const auto hit = shoot(*g, from, bead - from);
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->object, 0U);
        EXPECT_NEAR(hit->t, length(bead - from) - 1e-6, 1e-9);
    }
}

// occluded() and intersect() agree.
TEST(Geometry, OcclusionAgreesWithIntersection) {
    const auto g = build(mixed_scene({}));
    test::Random random(5);
    for (int i = 0; i < 20'000; ++i) {
        const Ray ray{random.in_cube(3), random.direction()};
        const auto hit = g->intersect(ray);
        const Real inf = std::numeric_limits<Real>::infinity();
        ASSERT_EQ(g->occluded(ray, inf), hit.has_value());
        if (!hit) continue;
        const Real margin = 1e-6 * g->radius() / std::abs(dot(hit->ng, ray.d));
        EXPECT_TRUE(g->occluded(ray, hit->t + margin));
        EXPECT_FALSE(g->occluded(ray, hit->t - margin));
        const auto within = g->intersect_within(ray, hit->t + margin);
        ASSERT_TRUE(within);
        EXPECT_EQ(within->t, hit->t);
        EXPECT_FALSE(g->intersect_within(ray, hit->t));
    }
}

// A cube that stands on a plane: from inside it, rays go out to the plane and not below it.
TEST(Geometry, ThingsStandOnPlanes) {
    const std::vector<Shape> bodies{Box{{-1, 0, -1}, {1, 2, 1}}, Cylinder{{0, 0, 0}, {0, 2, 0}}};
    test::Random random(6);
    for (const Real height : {0.0, 1e5, -0.1}) {
        const Transform m = Transform::translate({0.1, height, 0.7}) *
                            Transform::rotate({1, 2, 3}, 0.6) * Transform::scale({0.3, 0.7, 0.9});
        std::vector<PlacedShape> placed;
        for (const Shape& body : bodies) placed.push_back({body, {m}});
        placed.push_back({test::cube(), {m * Transform::translate({0, 1, 0})}});
        for (const PlacedShape& body : placed) {
            const auto g = build({body, {Plane{}, {m}}});
            for (int i = 0; i < 2000; ++i) {
                const Vec3 towards{random.between(-1, 1), -1, random.between(-1, 1)};
                const auto hit = shoot(*g, m.point({0, 0.5, 0}), m.direction(towards));
                ASSERT_TRUE(hit);
                EXPECT_EQ(hit->object, 1U) << body.shape.index();
            }
        }
    }
}

// Three boxes that touch: a ray is out of one before it is in the next, on its whole way.
TEST(Geometry, TouchingBodiesAreLeftBeforeTheNextIsEntered) {
    std::vector<PlacedShape> stack;
    for (const Real x : {0.1, 0.4, 0.7}) stack.push_back({Box{{x, -1, -1}, {x + 0.3, 1, 1}}});
    const auto g = build(stack);
    test::Random random(7);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 d = normalize({1, random.between(-0.5, 0.5), random.between(-0.5, 0.5)});
        Vec3 o = -0.7 * d;
        Real inside = 0;
        for (int faces = 0; faces < 12; ++faces) {
            const auto hit = g->intersect({o, d});
            if (!hit) break;
            if (dot(hit->ng, d) > 0) inside += hit->t;
            o = leave_surface(*hit, d);
        }
        EXPECT_NEAR(inside, 0.9 / d.x, 1e-9);
    }
}

// Hits do not depend on which build it is, nor on who asks from which thread.
TEST(Geometry, GivesTheSameHitsFromEveryBuildAndThread) {
    std::vector<PlacedShape> shapes = mixed_scene({});
    shapes.push_back({test::icosphere(5)});
    shapes.push_back({test::icosphere(5)});  // coincides with the one before
    const auto hash_of_hits = [](const Geometry& g) {
        test::Random random(8);
        std::uint64_t h = 0;
        for (int i = 0; i < 20'000; ++i) {
            const auto hit = g.intersect({random.in_cube(3), random.direction()});
            if (hit) h = hash(h, hit->object, std::bit_cast<std::uint64_t>(hit->t));
        }
        return h;
    };
    const auto first = build(shapes);
    const auto second = build(shapes);
    const std::uint64_t expected = hash_of_hits(*first);
    EXPECT_EQ(hash_of_hits(*second), expected);
    std::vector<std::uint64_t> found(4);
    std::vector<std::thread> threads;
    for (std::uint64_t& h : found) {
        threads.emplace_back([&] { h = hash_of_hits(*first); });
    }
    for (std::thread& thread : threads) thread.join();
    for (const std::uint64_t h : found) EXPECT_EQ(h, expected);
}

}  // namespace
}  // namespace bouguer::renderer
