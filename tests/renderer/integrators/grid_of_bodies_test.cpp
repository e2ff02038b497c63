// SPDX-License-Identifier: Apache-2.0
// Many bodies on a coarse grid, so that they share walls, edges and corners, stand in each other
// and in the same place, against what intervals along the ray say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/renderer/geometry/geometry_testing.h"
#include "tests/support/meshes.h"
#include "tests/support/poses.h"

namespace bouguer::renderer {
namespace {

using test::glass;
using test::matt;
using test::Pose;
using test::PosedScene;
using test::Random;
using test::Seen;

constexpr double kShare = 0.9;

struct GridBody {
    Vec3 lo, hi;
    int priority = 0;
    double transmittance = 1;  ///< a unit of length; 0: opaque
    double radiance = 0;       ///< of what is opaque
};

struct Span {
    Real from, to;
};

std::optional<Span> span_of(const GridBody& body, const Ray& ray) {
    Span span{0, 1e30};
    for (int axis = 0; axis < 3; ++axis) {
        const Real a = (body.lo[axis] - ray.o[axis]) / ray.d[axis];
        const Real b = (body.hi[axis] - ray.o[axis]) / ray.d[axis];
        span.from = std::max(span.from, std::min(a, b));
        span.to = std::min(span.to, std::max(a, b));
    }
    return span.from < span.to ? std::optional(span) : std::nullopt;
}

/// What a ray sees, by the rule: of the bodies around a point the one with the highest priority is
/// there, of those the first; what is opaque ends the ray. One share a change.
/// Empty where two opaque bodies begin in one place.
std::optional<double> expected(const std::vector<GridBody>& bodies, const Ray& ray,
                               double environment) {
    std::vector<Real> ends{0};
    for (const GridBody& body : bodies) {
        if (const auto span = span_of(body, ray)) {
            ends.push_back(span->from);
            ends.push_back(span->to);
        }
    }
    std::sort(ends.begin(), ends.end());
    double weight = 1;
    const GridBody* before = nullptr;
    int opaque = 0;
    const auto at = [&](Real t) {
        const GridBody* best = nullptr;
        for (const GridBody& body : bodies) {
            const auto span = span_of(body, ray);
            if (!span || t < span->from || t > span->to) continue;
            if (body.transmittance == 0) ++opaque;
            if (best != nullptr && best->transmittance == 0) continue;
            if (body.transmittance == 0) {
                best = &body;
                continue;
            }
            if (best == nullptr || body.priority > best->priority) best = &body;
        }
        return best;
    };
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const bool is_last = i + 1 == ends.size();
        if (!is_last && ends[i + 1] - ends[i] < 1e-9) continue;
        const Real middle = is_last ? ends[i] + 1 : (ends[i] + ends[i + 1]) / 2;
        const GridBody* here = at(middle);
        if (opaque > 1) return std::nullopt;
        if (opaque == 1) return weight * here->radiance;
        if (here != before && i > 0 && ends[i] > 0) weight *= kShare;
        if (here != nullptr) weight *= std::pow(here->transmittance, ends[i + 1] - ends[i]);
        before = here;
    }
    return weight * environment;
}

std::vector<GridBody> random_bodies(Random& random, int count) {
    std::vector<GridBody> bodies;
    const auto whole = [&](int lo, int hi) { return std::floor(random.between(lo, hi + 1)); };
    for (int i = 0; i < count; ++i) {
        GridBody body;
        body.lo = {whole(-2, 1), whole(-2, 1), whole(-2, 1)};
        body.hi = body.lo + Vec3{whole(1, 3), whole(1, 3), whole(1, 3)};
        body.priority = static_cast<int>(whole(-1, 1));
        body.transmittance = random.between(0.5, 0.95);
        if (random.uniform() < 0.15) {
            body.transmittance = 0;
            body.radiance = random.between(0.5, 1);
        }
        bodies.push_back(body);
    }
    return bodies;
}

/// As a box, a mesh, or an instance of the unit cube's mesh.
PlacedShape shape_of(const GridBody& body, Random& random) {
    static const auto cube = test::cube();
    const Real kind = random.uniform();
    if (kind < 0.33) return {Box{body.lo, body.hi}};
    if (kind < 0.67) return {test::box_mesh(body.lo, body.hi)};
    return {cube,
            {Transform::translate(0.5 * (body.lo + body.hi)) *
             Transform::scale(0.5 * (body.hi - body.lo))}};
}

class GridOfBodies : public testing::TestWithParam<Pose> {};

TEST_P(GridOfBodies, IsSeenAsIntervalsSay) {
    for (int number = 0; number < 40; ++number) {
        Random random(static_cast<std::uint64_t>(number) + 1);
        const auto bodies = random_bodies(random, 2 + number % 6);
        PosedScene scene(GetParam());
        scene.environment(1);
        for (const GridBody& body : bodies) {
            const bool is_opaque = body.transmittance == 0;
            HallMaterial m = is_opaque ? matt(0) : glass(1, body.transmittance);
            if (!is_opaque) m.k_st = kShare;
            scene.place(shape_of(body, random), m, body.priority);
            scene.shining(body.radiance);
        }
        for (int i = 0; i < 20; ++i) {
            const bool is_inside = i % 4 == 0;
            const Vec3 to = random.in_cube(3);
            const Vec3 from = is_inside ? random.in_cube(2.5) : 8 * random.direction();
            // A camera inside something opaque sees its inner side, which is no question here.
            const Ray ray{from, normalize(to - from)};
            const auto around = [&](const GridBody& b) {
                return b.transmittance == 0 && min(b.lo, from) == b.lo && max(b.hi, from) == b.hi;
            };
            if (std::any_of(bodies.begin(), bodies.end(), around)) continue;
            const auto should = expected(bodies, ray, 1);
            if (!should) continue;
            const Seen seen = scene.look(from, to);
            EXPECT_NEAR(seen.y, *should, 3e-6) << "scene " << number << ", ray " << i;
            EXPECT_TRUE(seen.counters.lost_bodies.empty()) << "scene " << number << ", ray " << i;
        }
    }
}

/// Blocks of half the size of a cube's third, which they fill.
class Blocks : public GridOfBodies {
  protected:
    Blocks() {
        scene_.environment(1);
        Random random(7);
        for (int i = 0; i < 27; ++i) {
            const Vec3 lo = Vec3{i % 3 * 1.0, i / 3 % 3 * 1.0, i / 9 * 1.0} - Vec3{1.5, 1.5, 1.5};
            scene_.place(shape_of({lo, lo + Vec3{1, 1, 1}, 0, 0, 0}, random), glass(1, 0.8));
        }
    }
    PosedScene scene_{GetParam()};
};

// Through edges and corners that eight of them share there is no gap.
TEST_P(Blocks, LeakNothingAtEdgesAndCorners) {
    for (int i = 0; i <= 8; ++i) {
        for (int j = 0; j <= 8; ++j) {
            const Real x = 0.25 * i - 1, y = 0.25 * j - 1;
            const Seen seen = scene_.look({5 * x, 5 * y, 5}, {0, 0, 0});
            EXPECT_NEAR(seen.y, std::pow(0.8, 3 * std::sqrt(1 + x * x + y * y)), 3e-6)
                << x << " " << y;
            EXPECT_TRUE(seen.counters.lost_bodies.empty()) << x << " " << y;
        }
    }
}

// A ray in the very plane of walls may be on either side of them, or in the crack as wide as
// rounding, but is not lost in a body for good.
TEST_P(Blocks, DoNotKeepRaysInTheirWalls) {
    for (const Real x : {-0.5, 0.5}) {
        for (const Real y : {-1.2, -0.5, 0.1, 0.5}) {
            for (const Seen& seen :
                 {scene_.look({x, y, 5}, {x, y, 0}), scene_.look({y, x, 5}, {y, x, 0}),
                  scene_.look({x, -5, y}, {x, 0, y})}) {
                EXPECT_GT(seen.y, 0.999 * std::pow(0.8, 5)) << x << " " << y;
                EXPECT_LT(seen.y, 1.001) << x << " " << y;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Blocks, testing::ValuesIn(test::poses()), test::pose_name);
INSTANTIATE_TEST_SUITE_P(All, GridOfBodies, testing::ValuesIn(test::poses()), test::pose_name);

}  // namespace
}  // namespace bouguer::renderer
