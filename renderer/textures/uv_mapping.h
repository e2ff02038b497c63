// SPDX-License-Identifier: Apache-2.0
// Where on a surface a texture lies.
#pragma once

#include <cmath>

#include "renderer/core/vec3.h"

namespace bouguer::renderer {

/// A texture's own coordinates s (to the right) and t (up) have period 1. On the surface, with u to
/// the right and v up, it is repeated `scale` times a unit of u and v, then turned
/// counter-clockwise by `rotate_deg`, then moved by `offset`, in units of u and v.
struct UvMapping {
    Vec2 scale{1, 1};
    Vec2 offset{};
    Real rotate_deg = 0;
};

/// A mapping with its sine and cosine worked out. Immutable.
class UvToTexture {
  public:
    explicit UvToTexture(const UvMapping& mapping)
        : offset_(mapping.offset),
          scale_(mapping.scale),
          cos_(std::cos(degrees_to_radians(mapping.rotate_deg))),
          sin_(std::sin(degrees_to_radians(mapping.rotate_deg))) {}

    /// The texture's coordinates at a place of the surface. Finite: what is not becomes 0.
    [[nodiscard]] Vec2 operator()(Vec2 uv) const {
        const Real u = uv.x - offset_.x, v = uv.y - offset_.y;
        return {finite(scale_.x * (cos_ * u + sin_ * v)), finite(scale_.y * (cos_ * v - sin_ * u))};
    }

  private:
    static Real finite(Real x) { return std::isfinite(x) ? x : 0; }

    Vec2 offset_, scale_;
    Real cos_, sin_;
};

/// The part of `x` behind the point, in [0, 1) for negative numbers too.
[[nodiscard]] inline Real fraction(Real x) {
    const Real f = x - std::floor(x);
    return f < 1 ? f : 0;  // of -1e-20 the difference rounds to 1
}

}  // namespace bouguer::renderer
