// SPDX-License-Identifier: Apache-2.0
// A coarse answer to whether anything of a mesh is near a point.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/geometry/bounds.h"
#include "renderer/geometry/shape.h"

namespace bouguer::renderer {

/// A grid over a mesh's bounding box that knows in which cells triangles lie. Immutable; thread-
/// safe.
class Occupancy {
  public:
    /// Of the mesh in its own coordinates.
    explicit Occupancy(const TriangleMesh& mesh);

    /// False: no triangle comes within `reach` (the mesh's own units) of `p`.
    [[nodiscard]] bool is_near(Vec3 p, Real reach) const;
    [[nodiscard]] std::uint64_t bytes() const { return occupied_.size() / 8; }

  private:
    /// The cells along one axis that [lo, hi] touches, inside the grid.
    [[nodiscard]] std::pair<int, int> cells(int axis, Real lo, Real hi) const;
    [[nodiscard]] std::size_t index(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(count_) +
                static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(count_) +
               static_cast<std::size_t>(x);
    }

    Bounds box_;
    int count_ = 1;  ///< of cells along each axis
    std::vector<bool> occupied_;
};

}  // namespace bouguer::renderer
