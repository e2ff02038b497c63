// SPDX-License-Identifier: Apache-2.0
// Axis-parallel bounding boxes.
#pragma once

#include <limits>

#include "renderer/core/vec3.h"

namespace bouguer::renderer {

/// The empty box at first.
struct Bounds {
    Vec3 lo = Vec3{1, 1, 1} * std::numeric_limits<Real>::infinity();
    Vec3 hi = Vec3{-1, -1, -1} * std::numeric_limits<Real>::infinity();

    void add(Vec3 p) {
        lo = min(lo, p);
        hi = max(hi, p);
    }
    void add(const Bounds& b) {
        lo = min(lo, b.lo);
        hi = max(hi, b.hi);
    }
    [[nodiscard]] bool empty() const { return !(lo.x <= hi.x); }
    [[nodiscard]] Vec3 middle() const { return 0.5 * lo + 0.5 * hi; }
    [[nodiscard]] Vec3 half_size() const { return 0.5 * hi - 0.5 * lo; }
};

}  // namespace bouguer::renderer
