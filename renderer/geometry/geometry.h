// SPDX-License-Identifier: Apache-2.0
// The geometry of a scene, ready for rays. The only door to Embree.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "renderer/core/result.h"
#include "renderer/core/vec3.h"
#include "renderer/geometry/shape.h"

namespace bouguer::renderer {

/// Where a ray meets a surface, refined in double precision.
struct Hit {
    Real t = 0;  ///< distance from the ray's origin, scene units
    Vec3 p;      ///< the point, on the surface to about 1e-7 of the scene's size
    Vec3 ng;  ///< unit geometric normal: out of closed shapes, along `normal` of planes and disks
    Vec3 ns;  ///< unit shading normal, on the same side as ng
    Vec2 uv;  ///< surface coordinates
    std::uint32_t object = 0;    ///< index into the placed shapes
    std::uint32_t instance = 0;  ///< which of that shape's instances
};

/// Immutable after build(); every const member may be called from any number of threads.
///
/// Coordinates of rays and hits are relative to origin(), the middle of the scene's bounds, which
/// is subtracted in double before anything is uploaded: a scene far from zero loses nothing. Embree
/// runs with ROBUST.
class Geometry {
  public:
    /// Error{Internal} when Embree refuses or memory runs out.
    [[nodiscard]] static Result<std::unique_ptr<const Geometry>> build(
        std::span<const PlacedShape> shapes);
    virtual ~Geometry() = default;

    /// The nearest surface along the ray; empty when it leaves the scene. `ray.d` is unit; rays
    /// with a component that is not finite hit nothing.
    [[nodiscard]] virtual std::optional<Hit> intersect(const Ray& ray) const = 0;
    /// Whether anything lies within `t_max` along the ray. Use infinity for lights at infinity.
    [[nodiscard]] virtual bool occluded(const Ray& ray, Real t_max) const = 0;

    /// The middle of the bounds of everything finite, world coordinates.
    [[nodiscard]] virtual Vec3 origin() const = 0;
    /// Radius of the sphere about origin() that holds everything finite; 0 for an empty scene.
    [[nodiscard]] virtual Real radius() const = 0;
    [[nodiscard]] virtual std::uint64_t num_triangles() const = 0;
    [[nodiscard]] virtual std::uint64_t memory_bytes() const = 0;  ///< as Embree counts it
};

/// The origin of a ray that leaves `hit` along `d`: moved off the surface by a few units in the
/// last place of single precision, to the side that `d` points to, so that it does not meet the
/// same surface again. Never an absolute length.
[[nodiscard]] Vec3 leave_surface(const Hit& hit, Vec3 d);

}  // namespace bouguer::renderer
