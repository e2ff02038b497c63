// SPDX-License-Identifier: Apache-2.0
// The geometry of a scene, ready for rays. The only door to Embree.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "renderer/core/result.h"
#include "renderer/core/vec3.h"
#include "renderer/geometry/bounds.h"
#include "renderer/geometry/shape.h"

namespace bouguer::renderer {

/// Where a ray meets a surface, refined in double precision.
struct Hit {
    Real t = 0;  ///< distance from the ray's origin, scene units
    Vec3 p;      ///< the point, on the surface as the document has it, in double precision
    Vec3 ng;  ///< unit geometric normal: out of closed shapes, along `normal` of planes and disks
    Vec3 ns;  ///< unit shading normal, on the same side as ng
    /// How far single-precision queries may see the surface off p, scene units; for
    /// leave_surface().
    Real error = 0;
    /// Surfaces closer than the sum of their resolutions, scene units, are in one place: more than
    /// the numbers of the document and double precision cannot tell apart.
    Real resolution = 0;
    std::uint32_t object = 0;     ///< index into the placed shapes
    std::uint32_t instance = 0;   ///< which of that shape's instances
    std::uint32_t part = 0;       ///< which of Geometry's parts; for surface_uv()
    std::uint32_t primitive = 0;  ///< which primitive of the part; for surface_uv()
    float u = 0, v = 0;           ///< barycentric coordinates in a triangle; for surface_uv()
    /// Whether an edge of the triangle is so near that rounding decides which side of it is met.
    bool is_at_edge = false;
    /// Whether the query knows that nothing else lies within reach of p along the ray.
    bool is_alone = false;
};

/// What resolution is along a ray that meets the surface of `hit` in direction `d`: more at grazing
/// incidence.
[[nodiscard]] inline Real resolution_along(const Hit& hit, Vec3 d) {
    constexpr Real kLeastCosine = 0x1p-20;
    return hit.resolution / std::max(std::abs(dot(hit.ng, d)), kLeastCosine);
}

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
/// Spheres, disks, boxes, cylinders and planes are intersected in double precision. Triangles are
/// found in single precision, each mesh in coordinates of its own where the scene is much larger
/// than it, and then met in double. Where an infinite plane and another surface are in one place,
/// the plane is the nearer one: things stand on it.
class Geometry {
  public:
    /// Error{InvalidInput}: a transform that has no inverse, a mesh index out of range, a shape
    /// that is not finite or has no size. Error{TooLarge}: over the memory limit. Error{Internal}:
    /// Embree refuses or memory runs out. The same shapes give the same hits for any number of
    /// threads.
    [[nodiscard]] static Result<std::unique_ptr<const Geometry>> build(
        std::span<const PlacedShape> shapes, const GeometryOptions& options = {});
    virtual ~Geometry() = default;

    /// The nearest surface along the ray, nearer than `t_max`; false when there is none, and `hit`
    /// then means nothing. What is in the place where the ray ends counts as not nearer: a lamp in
    /// a ceiling is not shadowed by it. `ray.d` is unit; rays with a component that is not finite
    /// hit nothing.
    virtual bool nearest(const Ray& ray, Real t_max, Hit& hit) const = 0;
    /// The same as a value.
    [[nodiscard]] std::optional<Hit> intersect_within(const Ray& ray, Real t_max) const {
        std::optional<Hit> result(std::in_place);
        if (!nearest(ray, t_max, *result)) result.reset();
        return result;
    }
    [[nodiscard]] std::optional<Hit> intersect(const Ray& ray) const {
        return intersect_within(ray, std::numeric_limits<Real>::infinity());
    }
    /// Whether anything lies within `t_max` along the ray, as nearest() has it. Use
    /// infinity for lights at infinity.
    [[nodiscard]] virtual bool occluded(const Ray& ray, Real t_max) const = 0;

    /// Every crossing of a surface with from <= t <= to, in the order of t (at equal t of object
    /// and instance), the ray being a whole line: `from` is finite, but may be negative. Replaces
    /// what `crossings` held. Of a convex shape both crossings count; of a mesh all.
    virtual void crossings(const Ray& ray, Real from, Real to,
                           std::vector<Hit>& crossings) const = 0;
    /// How far from a hit, along its normal, nearest() may confuse the order of surfaces, scene
    /// units. crossings() does not.
    [[nodiscard]] virtual Real reach(const Hit& hit) const = 0;

    /// Whether `p` is inside an instance of a closed shape or behind a plane. Meshes are asked with
    /// rays in three directions, the majority counts. Disks have no inside.
    [[nodiscard]] virtual bool contains(std::uint32_t object, std::uint32_t instance,
                                        Vec3 p) const = 0;
    /// Whether the surface of an instance may come within `reach` of `p`. May be wrong about
    /// meshes in one way: to say yes.
    [[nodiscard]] virtual bool touches(std::uint32_t object, std::uint32_t instance, Vec3 p,
                                       Real reach) const = 0;
    /// Whether two sides of a shape come so near to each other that nearest() may confuse them.
    /// Looks at every triangle of a mesh.
    [[nodiscard]] virtual bool is_thin(std::uint32_t object, std::uint32_t instance) const = 0;
    /// Of one instance, in the coordinates of rays; without end for planes.
    [[nodiscard]] virtual Bounds bounds(std::uint32_t object, std::uint32_t instance) const = 0;

    /// Surface coordinates of a hit: a mesh's own, interpolated, or the barycentric ones; of other
    /// shapes those of surface_coordinates.h. Apart from nearest() because few scenes need them.
    [[nodiscard]] virtual Vec2 surface_uv(const Hit& hit) const = 0;

    /// Where the smooth surface that a mesh's normals stand for lies over the facet of a hit, on
    /// the side of hit.ns [Hanika 2021]; hit.p where there is no facet or none needed. Rays to
    /// lamps that start there are not shadowed by the facets that the shading does not show.
    [[nodiscard]] virtual Vec3 smooth_point(const Hit& hit) const = 0;

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
/// Never an absolute length. What else lies so near must be asked for by crossings().
[[nodiscard]] inline Vec3 leave_surface(const Hit& hit, Vec3 d) {
    return hit.p + (dot(d, hit.ng) < 0 ? -hit.error : hit.error) * hit.ng;
}

}  // namespace bouguer::renderer
