// SPDX-License-Identifier: Apache-2.0
// A triangle mesh where it stands, in the form that Embree reads, and hits on it refined in double.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "renderer/core/result.h"
#include "renderer/core/transform.h"
#include "renderer/geometry/bounds.h"
#include "renderer/geometry/geometry.h"
#include "renderer/geometry/occupancy.h"
#include "renderer/geometry/shape.h"

namespace bouguer::renderer {

/// The plane of a triangle in double precision, as the document has it: dot(n, p) = offset.
struct TrianglePlane {
    Vec3 n;  ///< unit, to the side from which the mesh's corners run counter-clockwise
    Real offset = 0;
    float extent = 0;  ///< about the longest edge
};

/// A mesh's vertices in single precision, as Embree takes them, and what queries need of its
/// triangles. Immutable; shared by instances.
struct MeshBuffer {
    /// The positions of `mesh` under `transform`, rounded once, over `scale`; the planes are those
    /// of the triangles before rounding, not over `scale`.
    MeshBuffer(const TriangleMesh& mesh, const Transform& transform, Real scale);

    [[nodiscard]] Vec3 vertex(std::uint32_t i) const;  ///< not over `scale`
    [[nodiscard]] std::uint64_t bytes() const;

    Occupancy occupancy;     ///< of the mesh in its own coordinates
    std::vector<float> xyz;  ///< [vertex][xyz], and one more: Embree reads 16 bytes a vertex
    std::vector<TrianglePlane> planes;
    Real scale;
};

/// What a single-precision query says of a triangle.
struct TriangleHit {
    std::uint32_t primitive = 0;
    Real t = 0;  ///< scene units
    float u = 0, v = 0;
};

/// A mesh under one transform. Immutable; thread-safe.
class MeshPart {
  public:
    /// A copy of its own: `buffer` is in the coordinates of rays. `to_scene` takes the mesh's own
    /// coordinates to those of rays, which begin at `origin`; it is invertible.
    MeshPart(std::shared_ptr<const TriangleMesh> mesh, std::shared_ptr<const MeshBuffer> buffer,
             const Transform& to_scene, Vec3 origin);
    /// A mesh in coordinates of its own: `buffer` may be shared, and `from_buffer` takes it to the
    /// coordinates of rays.
    MeshPart(std::shared_ptr<const TriangleMesh> mesh, std::shared_ptr<const MeshBuffer> buffer,
             const Transform& to_scene, Vec3 origin, const Transform& from_buffer);

    /// Meets the plane of the triangle in double. Fills t, p, ng, error, resolution, u, v and
    /// primitive of `hit`; the triangle may turn out to lie behind the ray's origin, t <= 0.
    void refine(const Ray& ray, const TriangleHit& found, Hit& hit) const;
    /// Fills ns from the mesh's normals.
    void shade(Hit& hit) const;
    [[nodiscard]] Vec2 uv(const Hit& hit) const;

    /// The point of the smooth surface over a hit (see Geometry).
    [[nodiscard]] Vec3 smooth_point(const Hit& hit) const;
    /// Whether the triangles of two hits have a corner in common.
    [[nodiscard]] bool share_corner(const Hit& a, const Hit& b) const;
    /// Whether the point of a hit is not in its triangle after all, in double.
    [[nodiscard]] bool is_beside(const Hit& hit) const;

    /// From the coordinates of rays to the buffer's; for a mesh in coordinates of its own.
    [[nodiscard]] const Transform& to_buffer() const { return own_->to_buffer; }
    /// As Geometry has them, for the mesh.
    [[nodiscard]] bool touches(Vec3 p, Real reach) const;
    [[nodiscard]] const TriangleMesh& mesh() const { return *mesh_; }
    [[nodiscard]] Vec3 middle_of(std::uint32_t triangle) const;
    /// The worst error of a hit on this mesh, scene units. `size` is its largest coordinate.
    [[nodiscard]] Real worst_error(Real size) const;

  private:
    [[nodiscard]] Vec3 point_in(const TriangleHit& at) const;

    struct OwnCoordinates {
        Transform from_buffer, to_buffer;
        Real size;  ///< how much longer things are than in the buffer
    };

    std::shared_ptr<const TriangleMesh> mesh_;
    std::shared_ptr<const MeshBuffer> buffer_;
    std::unique_ptr<const OwnCoordinates> own_;  ///< null for a copy
    Real resolution_;  ///< what the numbers of a mesh file do not tell apart, scene units
    Transform to_scene_, to_mesh_;
};

}  // namespace bouguer::renderer
