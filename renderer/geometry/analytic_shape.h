// SPDX-License-Identifier: Apache-2.0
// Shapes with a closed form, intersected in double precision in their own space.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "renderer/core/transform.h"
#include "renderer/geometry/bounds.h"
#include "renderer/geometry/geometry.h"
#include "renderer/geometry/shape.h"

namespace bouguer::renderer {

/// The shapes in their canonical place: the unit sphere; the unit disk in z = 0; the cube
/// [-1, 1]^3; the cylinder of radius 1 and z in [0, 1] with its caps.
enum class UnitShape : std::uint8_t { Sphere, Disk, Box, Cylinder };

/// Which of two analytic surfaces at the same distance is met first: a ray that leaves one body
/// where it touches the next is out of the first before it is in the second, and what has no inside
/// is never skipped.
enum class CrossingRank : std::uint8_t { Enters, Leaves, Open };

/// Where a ray meets an analytic shape; `t` is infinite when it does not.
struct AnalyticHit {
    Real t = std::numeric_limits<Real>::infinity();
    CrossingRank rank = CrossingRank::Enters;
    std::uint8_t part = 0;  ///< box: the axis of the face; cylinder: 0 side, 1 cap; else 0
};

/// A unit shape under a transform. Immutable; thread-safe.
class AnalyticShape {
  public:
    /// A sphere, disk, box or cylinder under `instance`, in world coordinates. Empty when it has no
    /// size or the transform no inverse, and for planes and meshes.
    static std::optional<AnalyticShape> create(const Shape& shape, const Transform& instance);
    /// The same shape with its coordinates counted from `origin`.
    [[nodiscard]] AnalyticShape relative_to(Vec3 origin) const;

    /// The nearest point with t > 0.
    [[nodiscard]] AnalyticHit intersect(const Ray& ray) const;
    /// Where the line crosses the surface, before and behind the ray's origin: in and out, or once
    /// through a disk. Infinite t where it does not.
    [[nodiscard]] std::array<AnalyticHit, 2> crossings(const Ray& ray) const;
    /// Whether `p` is inside; never for a disk.
    [[nodiscard]] bool contains(Vec3 p) const;
    /// Whether the surface comes within `reach` of `p`.
    [[nodiscard]] bool touches(Vec3 p, Real reach) const;
    /// Fills t, p, ng, ns, error, resolution and primitive of `hit`. The point is put onto the
    /// surface, so that its error does not grow with the way the ray has come.
    void complete(const Ray& ray, AnalyticHit at, Hit& hit) const;
    /// See surface_coordinates.h. Caps of a cylinder are as disks. All in [0, 1].
    [[nodiscard]] Vec2 uv(const Hit& hit) const;

    [[nodiscard]] Bounds bounds() const;
    /// Distances that differ by less than this, at distance `t`, cannot be told apart.
    [[nodiscard]] Real thinnest() const { return thinnest_; }  ///< length of the shortest axis
    [[nodiscard]] Real resolution_at(Real t) const {
        return placing_ + kRounding * condition_ * (std::abs(t) + size_);
    }

  private:
    /// About 4000 units in the last place of double precision: covers some tens of roundings in a
    /// transform and a quadratic, and is still 1e-5 of what single precision can resolve.
    static constexpr Real kRounding = 0x1p-41;

    UnitShape kind_ = UnitShape::Sphere;
    Real placing_ = 0;    ///< what the numbers of the document leave open, scene units
    Real size_ = 0;       ///< length of the longest axis
    Real thinnest_ = 0;   ///< of the shortest; 0 for a disk
    Real condition_ = 1;  ///< how much the transform amplifies rounding, >= 1
    Real growth_ = 1;     ///< the most that a length becomes in the space of the unit shape
    Transform to_scene_;
    Transform to_unit_;
    Vec2 bottom_u_;  ///< of a cylinder: where u points on the cap at z = 0
};

}  // namespace bouguer::renderer
