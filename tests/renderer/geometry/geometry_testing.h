// SPDX-License-Identifier: Apache-2.0
// What the tests of geometry share.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "renderer/core/hash.h"
#include "renderer/geometry/geometry.h"

namespace bouguer::renderer::test {

inline std::unique_ptr<const Geometry> build(const std::vector<PlacedShape>& shapes,
                                             const GeometryOptions& options = {}) {
    auto geometry = Geometry::build(shapes, options);
    EXPECT_TRUE(geometry) << geometry.error().message;
    return std::move(*geometry);
}

/// Shoots a ray given in world coordinates and moves the hit back to them.
inline std::optional<Hit> shoot(const Geometry& geometry, Vec3 from, Vec3 towards) {
    auto hit = geometry.intersect({from - geometry.origin(), normalize(towards)});
    if (hit) hit->p += geometry.origin();
    return hit;
}

inline void expect_near(Vec3 a, Vec3 b, Real tolerance) {
    EXPECT_LE(length(a - b), tolerance) << "(" << a.x << ", " << a.y << ", " << a.z << ") is not ("
                                        << b.x << ", " << b.y << ", " << b.z << ")";
}

/// A sequence of uniform numbers that is the same everywhere.
class Random {
  public:
    explicit Random(std::uint64_t seed) : seed_(seed) {}
    /// In [0, 1).
    Real uniform() { return static_cast<Real>(hash(seed_, ++count_) >> 11U) * 0x1p-53; }
    Real between(Real lo, Real hi) { return lo + (hi - lo) * uniform(); }
    Vec3 in_cube(Real half) {
        return {between(-half, half), between(-half, half), between(-half, half)};
    }
    /// Uniform on the unit sphere.
    Vec3 direction() {
        const Real z = between(-1, 1);
        const Real phi = between(0, 2 * kPi);
        const Real r = std::sqrt(1 - z * z);
        return {r * std::cos(phi), r * std::sin(phi), z};
    }

  private:
    std::uint64_t seed_;
    std::uint64_t count_ = 0;
};

}  // namespace bouguer::renderer::test
