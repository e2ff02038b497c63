// SPDX-License-Identifier: Apache-2.0
// The geometry of a scene, ready for rays. The only door to Embree.
#pragma once

#include <cstdint>
#include <limits>
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
    Real error = 0;  ///< how far rays see the surface off p, scene units; for leave_surface()
    std::uint32_t object = 0;     ///< index into the placed shapes
    std::uint32_t instance = 0;   ///< which of that shape's instances
    std::uint32_t part = 0;       ///< which of Geometry's parts; for surface_uv()
    std::uint32_t primitive = 0;  ///< which primitive of the part; for surface_uv()
    float u = 0, v = 0;           ///< barycentric coordinates in a triangle; for surface_uv()
};

/// How a Geometry is built.
struct GeometryOptions {
    /// Over this, counting Embree's structures and our own: Error{TooLarge}.
    std::uint64_t max_memory_bytes = std::numeric_limits<std::uint64_t>::max();
    /// A mesh that stands in several places is copied into the scene for each, which is faster and
    /// more exact, as long as the copies have no more triangles than this together. Else the
    /// instances share one.
    std::uint64_t max_baked_triangles = 200'000;
};

/// Immutable after build(); every const member may be called from any number of threads.
///
/// Coordinates of rays and hits are relative to origin(), the middle of the scene's bounds, which
/// is subtracted in double before anything is uploaded: a scene far from zero loses nothing. Embree
/// runs with ROBUST and sees the scene scaled to about unit size, so no scale overflows.
///
/// Spheres, disks, boxes, cylinders and planes are intersected in double, triangles in single
/// precision; the nearest hit is then refined in double. Where an infinite plane and another
/// surface lie closer than can be told apart, the plane is the nearer one: things stand on it.
class Geometry {
  public:
    /// Error{InvalidInput}: a transform that has no inverse, a mesh index out of range, a shape
    /// that is not finite or has no size. Error{TooLarge}: over the memory limit. Error{Internal}:
    /// Embree refuses or memory runs out. The same shapes give the same hits for any number of
    /// threads.
    [[nodiscard]] static Result<std::unique_ptr<const Geometry>> build(
        std::span<const PlacedShape> shapes, const GeometryOptions& options = {});
    virtual ~Geometry() = default;

    /// The nearest surface along the ray; empty when it leaves the scene. `ray.d` is unit; rays
    /// with a component that is not finite hit nothing.
    [[nodiscard]] virtual std::optional<Hit> intersect(const Ray& ray) const = 0;
    /// As intersect(), but of the surfaces nearer than `t_max` only; cheaper when there is none.
    [[nodiscard]] virtual std::optional<Hit> intersect_within(const Ray& ray, Real t_max) const {
        auto hit = intersect(ray);
        if (hit && !(hit->t < t_max)) hit.reset();
        return hit;
    }
    /// Whether anything lies within `t_max` along the ray. Use infinity for lights at infinity.
    [[nodiscard]] virtual bool occluded(const Ray& ray, Real t_max) const = 0;

    /// Surface coordinates of a hit: a mesh's own, interpolated, or the barycentric ones; those of
    /// AnalyticShape::uv; for planes the coordinates along two axes of the plane, scene units.
    /// Apart from intersect() because few scenes need them.
    [[nodiscard]] virtual Vec2 surface_uv(const Hit& hit) const = 0;

    /// The middle of the bounds of everything finite, world coordinates.
    [[nodiscard]] virtual Vec3 origin() const = 0;
    /// Radius of the sphere about origin() that holds everything finite; 0 for an empty scene.
    [[nodiscard]] virtual Real radius() const = 0;
    [[nodiscard]] virtual std::uint64_t num_triangles() const = 0;
    [[nodiscard]] virtual std::uint64_t memory_bytes() const = 0;  ///< Embree's and our own
};

/// The origin of a ray that leaves `hit` along `d`: moved off the surface by `hit.error`, to the
/// side that `d` points to, so that it does not meet the same surface again. That is a few units in
/// the last place of the coordinates: of single precision for triangles, of double for the others.
/// Never an absolute length.
[[nodiscard]] inline Vec3 leave_surface(const Hit& hit, Vec3 d) {
    return hit.p + (dot(d, hit.ng) < 0 ? -hit.error : hit.error) * hit.ng;
}

}  // namespace bouguer::renderer
