// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/surface_coordinates.h"

#include "tests/renderer/geometry/geometry_testing.h"

namespace bouguer::renderer {
namespace {

using test::build;

/// One of each that has coordinates of its own, none in a special place.
const std::vector<Shape>& shapes() {
    static const std::vector<Shape> all{
        Sphere{{0.1, 0.2, -0.3}, 0.9},
        Box{{-1, -0.7, -0.8}, {0.9, 1, 0.6}},
        Cylinder{{0.1, -0.9, 0.2}, {-0.1, 0.8, 0.3}, 0.6},
        Cylinder{{-0.9, 0.1, 0}, {0.7, 0, 0.4}, 0.5},
        Disk{{0.1, 0.1, 0.1}, {0.3, -0.2, -0.9}, 1},
        Disk{{}, {0, 1, 0}, 1},
        Plane{{0.1, 0, 0.1}, {-0.6, 0.5, 0.2}},
        Plane{{0, 0, 0.1}, {0.1, 0.3, -1}},
    };
    return all;
}

/// How an area of (u, v) compares to that of the surface, seen from the side of the normal: the
/// sign of (dp/du x dp/dv) . n. By differences; 0 where a seam or an edge lies between.
Real handedness(const Geometry& g, Vec3 from, Vec3 towards) {
    constexpr Real kStep = 1e-5;
    const auto hit = g.intersect({from, towards});
    if (!hit) return 0;
    const Frame frame(hit->ng);
    const auto moved = [&](Vec3 along) {
        return g.intersect({hit->p + kStep * along + 1e-3 * hit->ng, -hit->ng});
    };
    const auto a = moved(frame.x), b = moved(frame.y);
    if (!a || !b || a->primitive != hit->primitive || b->primitive != hit->primitive) return 0;
    const Vec2 at = g.surface_uv(*hit), at_a = g.surface_uv(*a), at_b = g.surface_uv(*b);
    const Real area = (at_a.x - at.x) * (at_b.y - at.y) - (at_b.x - at.x) * (at_a.y - at.y);
    return std::abs(at_a.x - at.x) + std::abs(at_b.x - at.x) < 0.5 ? area / (kStep * kStep) : 0;
}

/// Looks at each shape under `transform` from all sides; expects handedness of one sign.
void expect_handedness(const Transform& transform, Real sign) {
    test::Random random(5);
    for (std::size_t i = 0; i < shapes().size(); ++i) {
        const auto g = build({{shapes()[i], {transform}}});
        int seen = 0;
        for (int k = 0; k < 2000; ++k) {
            const Vec3 from = 6 * random.direction();
            const Real found = handedness(*g, from, normalize(random.in_cube(0.5) - from));
            if (found == 0) continue;
            ++seen;
            ASSERT_GT(sign * found, 1e-3) << "shape " << i;
        }
        EXPECT_GT(seen, 500) << "shape " << i;
    }
}

TEST(SurfaceCoordinates, AreRightHandedFromOutside) { expect_handedness({}, 1); }

TEST(SurfaceCoordinates, AreRightHandedUnderTurnsAndScales) {
    const Transform turn = Transform::rotate({1, 2, -3}, 2.5);
    expect_handedness(turn, 1);
    expect_handedness(Transform::scale({0.5, 1.6, 0.9}), 1);
    expect_handedness(turn * Transform::scale({1.3, 0.6, 0.9}) * Transform::rotate({0, 1, 1}, -1),
                      1);
    expect_handedness(Transform::scale({-1, 1, -1}), 1);  // half a turn
}

// The picture goes with the object: what stands before a mirror is mirrored, and so is its picture.
TEST(SurfaceCoordinates, AreMirroredWithTheObject) {
    expect_handedness(Transform::scale({-1, 1, 1}), -1);
    expect_handedness(Transform::scale({1, 1, -0.7}) * Transform::rotate({1, 1, 0}, 1), -1);
    expect_handedness(Transform::scale({-1, -1, -1}), -1);
}

TEST(UprightFrame, HasVUpOnWallsAndKnownAxesOnFloorsAndCeilings) {
    for (int i = 0; i < 360; ++i) {
        const Real angle = degrees_to_radians(i);
        const Vec3 n{std::sin(angle), 0, std::cos(angle)};
        const Frame wall = upright_frame(n);
        test::expect_near(wall.y, {0, 1, 0}, 1e-14);
        test::expect_near(wall.x, {n.z, 0, -n.x}, 1e-14);
    }
    test::expect_near(upright_frame({0, 1, 0}).x, {1, 0, 0}, 0);
    test::expect_near(upright_frame({0, 1, 0}).y, {0, 0, -1}, 0);
    test::expect_near(upright_frame({0, -1, 0}).x, {1, 0, 0}, 0);
    test::expect_near(upright_frame({0, -1, 0}).y, {0, 0, 1}, 0);
}

TEST(UprightFrame, IsAFrame) {
    test::Random random(6);
    const Real k = std::sin(degrees_to_radians(42.5));
    std::vector<Vec3> normals{{0, std::sqrt(1 - k * k), -k}, {0, -std::sqrt(1 - k * k), -k}};
    for (int i = 0; i < 1000; ++i) normals.push_back(random.direction());
    for (const Vec3 n : normals) {
        const Frame frame = upright_frame(n);
        test::expect_near(frame.z, n, 0);
        test::expect_near(cross(frame.x, frame.y), n, 1e-14);
        EXPECT_NEAR(length(frame.x), 1, 1e-14);
        EXPECT_NEAR(length(frame.y), 1, 1e-14);
    }
}

/// How far the frame turns at most when the normal turns by `angle`, over `angle`.
Real turning(Vec3 n, Real angle) {
    const Frame before = upright_frame(n);
    Real most = 0;
    for (int i = 0; i < 12; ++i) {
        const Real a = 2 * kPi * i / 12;
        const Vec3 aside = std::cos(a) * before.x + std::sin(a) * before.y;
        const Frame after = upright_frame(std::cos(angle) * n + std::sin(angle) * aside);
        most = std::max({most, length(after.x - before.x), length(after.y - before.y)});
    }
    return most / angle;
}

// Also where single numbers of the normal are 0 or change their sign.
TEST(UprightFrame, TurnsALittleWhereTheNormalDoes) {
    for (const Real x : {-1.0, 0.0, 1.0}) {
        for (const Real y : {-1.0, 0.0, 1.0}) {
            for (const Real z : {-1.0, 0.0, 1.0}) {
                if (x == 0 && y == 0 && z == 0) continue;
                const bool is_near_one = x == 0 && y != 0 && z == -1;  // slope of 45 degrees
                for (const Real angle : {1e-3, 1e-9}) {
                    EXPECT_LT(turning(normalize({x, y, z}), angle), is_near_one ? 25 : 4)
                        << x << " " << y << " " << z;
                }
            }
        }
    }
    test::Random random(7);
    const Real k = std::sin(degrees_to_radians(42.5));
    for (int i = 0; i < 5000; ++i) {
        Vec3 n = random.direction();
        if (i % 2 == 0) n = normalize({n.x, n.y, 0});
        const Real away = length(Vec3{n.x, std::abs(n.y), n.z} - Vec3{0, std::sqrt(1 - k * k), -k});
        if (away > 0.01) {
            EXPECT_LT(turning(n, 1e-3), 2 + 2 / away) << n.x << " " << n.y << " " << n.z;
        }
    }
}

Vec2 coordinates(const Geometry& g, Vec3 from, Vec3 towards) {
    const auto hit = g.intersect({from - g.origin(), normalize(towards)});
    EXPECT_TRUE(hit);
    return hit ? g.surface_uv(*hit) : Vec2{};
}

void expect_coordinates(const Shape& shape, Vec3 from, Vec3 towards, Vec2 expected,
                        const Transform& transform = {}) {
    const Vec2 uv = coordinates(*build({{shape, {transform}}}), from, towards);
    EXPECT_NEAR(uv.x, expected.x, 1e-12);
    EXPECT_NEAR(uv.y, expected.y, 1e-12);
}

// A normal that differs by 2e-9 turned the picture by 180 degrees.
TEST(SurfaceCoordinates, OfWallsDoNotJump) {
    for (const Real z : {-1e-9, -1e-17, -0.0, 0.0, 1e-17, 1e-9}) {
        const Vec2 uv = coordinates(*build({{Plane{{}, {1, 0, z}}}}), {5, 0.25, -0.5}, {-1, 0, 0});
        EXPECT_NEAR(uv.x, 0.5, 1e-8);
        EXPECT_NEAR(uv.y, 0.25, 1e-8);
    }
}

TEST(SurfaceCoordinates, OfPlanesGoWithTheirTransform) {
    const Plane front{{0, 0, 2}, {0, 0, 5}};
    expect_coordinates(front, {0.25, 0.5, 9}, {0, 0, -1}, {0.25, 0.5});
    // The same wall, given at once or turned about the vertical.
    expect_coordinates(Plane{{2, 0, 0}, {1, 0, 0}}, {9, 0.5, -0.25}, {-1, 0, 0}, {0.25, 0.5});
    expect_coordinates(front, {9, 0.5, -0.25}, {-1, 0, 0}, {0.25, 0.5},
                       Transform::rotate({0, 1, 0}, kPi / 2));
    expect_coordinates(front, {0.25, 0.5, 9}, {0, 0, -1}, {-0.75, -6.5},
                       Transform::translate({1, 7, 3}));
    expect_coordinates(front, {0.25, 0.5, 9}, {0, 0, -1}, {0.125, 0.125},
                       Transform::scale({2, 4, 1}));
    expect_coordinates(front, {0.25, 0.5, 9}, {0, 0, -1}, {0.5, -0.25},
                       Transform::rotate({0, 0, 1}, kPi / 2));
}

TEST(SurfaceCoordinates, OfSpheresAreLongitudeAndLatitude) {
    const Sphere sphere{{9, 9, 9}, 3};
    expect_coordinates(sphere, {9, 9, -9}, {0, 0, 1}, {0.25, 0.5});
    expect_coordinates(sphere, {-9, 9, 9}, {1, 0, 0}, {0.5, 0.5});
    expect_coordinates(sphere, {9, 9, 20}, {0, 0, -1}, {0.75, 0.5});
    const Real high = 9 + 3 * std::sqrt(0.5);
    expect_coordinates(sphere, {9, high, 20}, {0, 0, -1}, {0.75, 0.75});
    EXPECT_NEAR(coordinates(*build({{sphere}}), {9, 20, 9}, {0, -1, 0}).y, 1, 1e-12);
    EXPECT_NEAR(coordinates(*build({{sphere}}), {9, -20, 9}, {0, 1, 0}).y, 0, 1e-12);
}

TEST(SurfaceCoordinates, OfCylindersAreAngleAndHeightAndThoseOfDisks) {
    const Cylinder can{{0, 0, 0}, {0, 4, 0}, 2};
    expect_coordinates(can, {-9, 1, 0}, {1, 0, 0}, {0.5, 0.25});
    expect_coordinates(can, {0, 1, 9}, {0, 0, -1}, {0.75, 0.25});
    expect_coordinates(can, {1, 9, -1}, {0, -1, 0}, {0.75, 0.75});
    expect_coordinates(can, {1, -9, -1}, {0, 1, 0}, {0.75, 0.25});
    expect_coordinates(Disk{{0, 4, 0}, {0, 1, 0}, 2}, {1, 9, -1}, {0, -1, 0}, {0.75, 0.75});
    expect_coordinates(Disk{{0, 0, 0}, {0, -1, 0}, 2}, {1, -9, -1}, {0, 1, 0}, {0.75, 0.25});
    // Lying: its bottom looks to -z, where v is up.
    const Cylinder log{{0, 0, 0}, {0, 0, 4}, 2};
    expect_coordinates(log, {1, -1, 9}, {0, 0, -1}, {0.75, 0.25});
    expect_coordinates(log, {1, -1, -9}, {0, 0, 1}, {0.25, 0.25});
}

// The axis of a cylinder turned by 2e-9 turned the picture by 180 degrees.
TEST(SurfaceCoordinates, OfCylindersDoNotJump) {
    const auto at = [](Real z) {
        return coordinates(*build({{Cylinder{{0, 0, 0}, {4, 0, z}, 2}}}), {1, 9, -0.5}, {0, -1, 0});
    };
    const Vec2 a = at(1e-9), b = at(-1e-9);
    EXPECT_NEAR(a.x, b.x, 1e-8);
    EXPECT_NEAR(a.y, b.y, 1e-8);
}

}  // namespace
}  // namespace bouguer::renderer
