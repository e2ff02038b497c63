// SPDX-License-Identifier: Apache-2.0
// Polygons into triangles, for the readers of mesh files.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/core/vec3.h"

namespace bouguer::renderer {

/// A polygon that is not convex may not have more corners: its time grows with their square.
inline constexpr std::size_t kMaxConcaveCorners = 10'000;

enum class PolygonFault : std::uint8_t {
    None,
    TooManyCorners,  ///< not convex, and over kMaxConcaveCorners: nothing was made
    NotSimple        ///< its border crosses itself; what was made covers it in some way
};

/// Cuts polygons into triangles. Keeps its memory from one to the next; not thread-safe.
class PolygonCutter {
  public:
    using Triangle = std::array<std::uint32_t, 3>;

    /// Cuts a polygon of n >= 3 corners into n - 2 triangles, appended to `triangles` as indices
    /// into `corners`, wound as the polygon is. A convex one becomes a fan about its first corner.
    /// Any other simple one, and one whose fan would have a flat triangle, is cut ear by ear
    /// [Meisters 1975], in the coordinate plane that sees most of it; ears that have an area go
    /// first, so that a corner on a straight border keeps a triangle that has one. Its border may
    /// touch itself, as that of a polygon with a slit to a hole does.
    PolygonFault cut(std::span<const Vec3> corners, std::vector<Triangle>& triangles);

    /// How many steps the polygons that are not convex have taken, about.
    [[nodiscard]] std::uint64_t steps() const { return steps_; }

  private:
    std::vector<Vec2> flat_;
    std::uint64_t steps_ = 0;
};

/// Twice the area vector of a polygon [Newell], over the square of its size: along the direction
/// from which the corners run counter-clockwise. Zero when they have no area.
[[nodiscard]] Vec3 area_vector(std::span<const Vec3> corners);

}  // namespace bouguer::renderer
