// SPDX-License-Identifier: Apache-2.0
// A triangle mesh where it stands, in the form that Embree reads, and hits on it refined in double.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "renderer/core/result.h"
#include "renderer/core/transform.h"
#include "renderer/geometry/bounds.h"
#include "renderer/geometry/geometry.h"
#include "renderer/geometry/shape.h"

namespace bouguer::renderer {

/// Vertex positions in single precision, as Embree takes them: [vertex][xyz], and one float more
/// because Embree reads 16 bytes a vertex.
struct VertexBuffer {
    std::vector<float> xyz;
    [[nodiscard]] Vec3 vertex(std::uint32_t i) const {
        const float* p = &xyz[3 * std::size_t{i}];
        return {p[0], p[1], p[2]};
    }
};

/// The positions of `mesh` under `transform`, rounded once.
[[nodiscard]] VertexBuffer make_vertex_buffer(const TriangleMesh& mesh, const Transform& transform);

/// What a single-precision query says of a triangle.
struct TriangleHit {
    std::uint32_t primitive = 0;
    Real t = 0;  ///< scene units
    float u = 0, v = 0;
};

/// A mesh under one transform. Immutable; thread-safe.
class MeshPart {
  public:
    /// `buffer` holds the mesh's vertices; `from_buffer` takes them to the coordinates of rays, and
    /// is empty when it only scales by `scale`. `to_scene` takes the mesh's own coordinates to
    /// those of rays; it is invertible.
    MeshPart(std::shared_ptr<const TriangleMesh> mesh, std::shared_ptr<const VertexBuffer> buffer,
             std::optional<Transform> from_buffer, Real scale, const Transform& to_scene);

    /// Computes t anew in double from the vertices that Embree saw. Fills t, p, ng, error, u, v and
    /// primitive of `hit`; returns false when the triangle lies behind the ray's origin after all.
    [[nodiscard]] bool refine(const Ray& ray, const TriangleHit& at, Hit& hit) const;
    /// Fills ns from the mesh's normals.
    void shade(Hit& hit) const;
    [[nodiscard]] Vec2 uv(const Hit& hit) const;

  private:
    std::shared_ptr<const TriangleMesh> mesh_;
    std::shared_ptr<const VertexBuffer> buffer_;
    std::optional<Transform> from_buffer_;
    Real scale_;
    Real rounding_;  ///< how far a query may be off, of the coordinates' size
    Real outwards_;  ///< -1 where the transform mirrors, else 1
    Transform to_mesh_;
};

}  // namespace bouguer::renderer
