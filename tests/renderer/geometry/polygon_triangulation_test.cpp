// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/polygon_triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "renderer/geometry/orientation.h"

namespace bouguer::renderer {
namespace {

/// The sum of the triangles' areas along z; a triangle that winds the other way makes it wrong.
Real signed_area(const std::vector<Vec3>& p,
                 const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    Real sum = 0;
    for (const auto& [a, b, c] : triangles) {
        const Real area = cross(p[b] - p[a], p[c] - p[a]).z / 2;
        EXPECT_GE(area, -1e-12);
        sum += area;
    }
    return sum;
}

Real shoelace(const std::vector<Vec3>& p) {
    Real sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec3 a = p[i], b = p[(i + 1) % p.size()];
        sum += (a.x * b.y - b.x * a.y) / 2;
    }
    return sum;
}

/// Whatever corner comes first.
void expect_covered(std::vector<Vec3> p) {
    for (std::size_t first = 0; first < p.size(); ++first) {
        std::vector<std::array<std::uint32_t, 3>> triangles;
        EXPECT_EQ(PolygonCutter().cut(p, triangles), PolygonFault::None) << first;
        EXPECT_EQ(triangles.size(), p.size() - 2);
        EXPECT_NEAR(signed_area(p, triangles), shoelace(p), 1e-9) << first;
        std::rotate(p.begin(), p.begin() + 1, p.end());
    }
}

TEST(PolygonTriangulation, CoversAnEll) {
    expect_covered({{0, 0, 0}, {1, 0, 0}, {1, 0.5, 0}, {0.5, 0.5, 0}, {0.5, 1, 0}, {0, 1, 0}});
}

TEST(PolygonTriangulation, CoversADartAndAComb) {
    expect_covered({{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5, 1, 0}});
    std::vector<Vec3> comb{{0, -1, 0}, {40, -1, 0}};
    for (int i = 20; i > 0; --i) {
        comb.push_back({2.0 * i, 3, 0});
        comb.push_back({2.0 * i - 1, 0, 0});
    }
    expect_covered(comb);
}

// Corners on straight borders, as beside finer faces.
TEST(PolygonTriangulation, KeepsCornersOnStraightBorders) {
    expect_covered(
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}});
}

// Stars of random radii about a point are simple, and mostly not convex.
TEST(PolygonTriangulation, CoversRandomStars) {
    std::mt19937 random(7);
    std::uniform_real_distribution<Real> radius(0.2, 2), many(5, 40);
    for (int i = 0; i < 40; ++i) {
        const int n = static_cast<int>(many(random));
        std::vector<Vec3> star;
        for (int k = 0; k < n; ++k) {
            const Real r = radius(random), angle = 2 * kPi * k / n;
            star.push_back({r * std::cos(angle), r * std::sin(angle), 0});
        }
        expect_covered(star);
    }
}

/// Corners in random places, in an order whose border does not cross itself: crossings are undone
/// one by one, each of which makes the border shorter.
std::vector<Vec3> random_polygon(std::mt19937& random, std::size_t n) {
    std::uniform_real_distribution<Real> place(0, 1);
    std::vector<Vec3> p;
    for (std::size_t i = 0; i < n; ++i) p.push_back({place(random), place(random), 0});
    const auto left = [&](std::size_t a, std::size_t b, std::size_t c) {
        return cross(p[b % n] - p[a % n], p[c % n] - p[a % n]).z > 0;
    };
    for (bool is_crossed = true; is_crossed;) {
        is_crossed = false;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t k = i + 2; k < n - (i == 0 ? 1 : 0); ++k) {
                if (left(i, i + 1, k) == left(i, i + 1, k + 1)) continue;
                if (left(k, k + 1, i) == left(k, k + 1, i + 1)) continue;
                std::reverse(p.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                             p.begin() + static_cast<std::ptrdiff_t>(k) + 1);
                is_crossed = true;
            }
        }
    }
    if (shoelace(p) < 0) std::reverse(p.begin(), p.end());
    return p;
}

TEST(PolygonTriangulation, CoversRandomSimplePolygons) {
    std::mt19937 random(11);
    for (int i = 0; i < 100; ++i) expect_covered(random_polygon(random, 4 + random() % 40));
}

// On a lattice corners lie on lines with others, and borders touch corners.
TEST(PolygonTriangulation, CoversRandomPolygonsOnALattice) {
    std::mt19937 random(12);
    for (int i = 0; i < 100; ++i) {
        std::vector<Vec3> stairs{{0, 0, 0}};
        const int n = 3 + static_cast<int>(random() % 12);
        for (int k = 0; k < n; ++k) {
            const Real y = 1 + static_cast<Real>(random() % 3);
            stairs.push_back({static_cast<Real>(k), -y, 0});
            stairs.push_back({static_cast<Real>(k + 1), -y, 0});
        }
        for (int k = n; k > 0; --k) {
            const Real y = static_cast<Real>(random() % 3);
            stairs.push_back({static_cast<Real>(k), y, 0});
            stairs.push_back({static_cast<Real>(k - 1), y, 0});
        }
        expect_covered(stairs);
    }
}

// A square with a square hole, as one polygon with a slit to it: 4 - 1.
TEST(PolygonTriangulation, CoversAPolygonWithASlitToItsHole) {
    expect_covered({{0, 0, 0},
                    {2, 0, 0},
                    {2, 2, 0},
                    {0, 2, 0},
                    {0, 0, 0},
                    {0.5, 0.5, 0},
                    {0.5, 1.5, 0},
                    {1.5, 1.5, 0},
                    {1.5, 0.5, 0},
                    {0.5, 0.5, 0}});
}

// In a plane that is along no axis, with corners on its sides that rounding moves off them.
TEST(PolygonTriangulation, CoversSlantedPolygons) {
    const std::vector<Vec3> ell{{0, 0, 0},     {0.3, 0, 0}, {1, 0, 0}, {1, 0.5, 0}, {0.7, 0.5, 0},
                                {0.5, 0.5, 0}, {0.5, 1, 0}, {0, 1, 0}, {0, 0.1, 0}};
    const Frame frame(normalize(Vec3{0.3, -0.5, 0.4}));
    for (std::size_t first = 0; first < ell.size(); ++first) {
        std::vector<Vec3> p;
        for (std::size_t i = 0; i < ell.size(); ++i)
            p.push_back(Vec3{100, 200, -50} + frame.to_world(ell[(first + i) % ell.size()]));
        std::vector<std::array<std::uint32_t, 3>> triangles;
        EXPECT_EQ(PolygonCutter().cut(p, triangles), PolygonFault::None);
        Vec3 sum;
        Real area = 0;
        for (const auto& [a, b, c] : triangles) {
            const Vec3 part = 0.5 * cross(p[b] - p[a], p[c] - p[a]);
            sum += part;
            area += length(part);
        }
        EXPECT_NEAR(dot(sum, frame.z), 0.75, 1e-12) << first;
        EXPECT_NEAR(area, 0.75, 1e-12) << "nothing is covered twice";
    }
}

// No triangle without an area is made where one with an area can be.
TEST(PolygonTriangulation, MakesNoFlatTriangleOfCornersOnStraightBorders) {
    std::vector<Vec3> p{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}};
    for (std::size_t first = 0; first < p.size(); ++first) {
        std::vector<std::array<std::uint32_t, 3>> triangles;
        PolygonCutter().cut(p, triangles);
        for (const auto& [a, b, c] : triangles)
            EXPECT_GT(cross(p[b] - p[a], p[c] - p[a]).z, 0.5) << first;
        std::rotate(p.begin(), p.begin() + 1, p.end());
    }
}

// Of a quad that is bent, the diagonal inside is taken: over the corner that is drawn in.
TEST(PolygonTriangulation, CutsBentDartsInside) {
    expect_covered({{0, 0, 0.1}, {2, 1, -0.1}, {0, 2, 0.2}, {0.5, 1, 0}});
}

TEST(PolygonTriangulation, RefusesVeryManyCornersThatAreNotConvex) {
    std::vector<Vec3> star;
    for (std::size_t i = 0; i <= kMaxConcaveCorners; ++i) {
        const Real angle = 2 * kPi * static_cast<Real>(i) / (kMaxConcaveCorners + 1.0);
        const Real r = i % 2 == 0 ? 1 : 2;
        star.push_back({r * std::cos(angle), r * std::sin(angle), 0});
    }
    std::vector<std::array<std::uint32_t, 3>> triangles;
    EXPECT_EQ(PolygonCutter().cut(star, triangles), PolygonFault::TooManyCorners);
    EXPECT_TRUE(triangles.empty());
}

TEST(PolygonTriangulation, LeavesConvexPolygonsAsFans) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const std::vector<Vec3> square{{0, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0, 1, 5}};
    EXPECT_EQ(PolygonCutter().cut(square, triangles), PolygonFault::None);
    EXPECT_EQ(triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
    EXPECT_EQ(triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
}

TEST(PolygonTriangulation, SaysWhatCrossesItself) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const std::vector<Vec3> bow{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}};
    EXPECT_EQ(PolygonCutter().cut(bow, triangles), PolygonFault::NotSimple);
    std::vector<Vec3> star;  // turns left at every corner, and goes round twice
    for (int i = 0; i < 5; ++i)
        star.push_back({std::cos(0.8 * kPi * i), std::sin(0.8 * kPi * i), 0});
    EXPECT_EQ(PolygonCutter().cut(star, triangles), PolygonFault::NotSimple);
}

// The sign of 2^-52 on coordinates of 12: products alone would round it away.
TEST(Orientation, IsNeverWrong) {
    const Real ulp = 0x1p-52;
    for (const Real step : {-ulp, 0.0, ulp}) {
        const Real area = orientation({0.5 + step, 0.5}, {12, 12}, {24, 24});
        EXPECT_EQ(area > 0, step < 0) << step;
        EXPECT_EQ(area<0, step> 0) << step;
    }
}

}  // namespace
}  // namespace bouguer::renderer
