// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/polygon_triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

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
}

}  // namespace
}  // namespace bouguer::renderer
