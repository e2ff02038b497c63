// SPDX-License-Identifier: Apache-2.0
// Polygons with attributes by corner, as mesh files have them, on their way to a TriangleMesh.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "renderer/core/result.h"
#include "renderer/geometry/mesh_file.h"
#include "renderer/geometry/shape.h"

namespace bouguer::renderer {

/// A corner of a polygon: indices into positions, texture coordinates and normals; kNone where the
/// file gives none.
struct PolygonCorner {
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t v = kNone, vt = kNone, vn = kNone;
    bool operator==(const PolygonCorner&) const = default;
};

/// Filled by the reader of a format.
struct PolygonMesh {
    std::vector<Vec3> positions, normals;
    std::vector<Vec2> uvs;
    std::vector<PolygonCorner> corners;  ///< of all polygons, one after the other
    std::vector<std::uint32_t> sizes;    ///< of each polygon, 3 or more
    std::vector<std::uint64_t> lines;    ///< where each stands in a text; or empty
    std::uint64_t small_faces = 0;       ///< of one or two corners: not here
    MeshNotes notes;

    /// How many triangles the polygons will be.
    [[nodiscard]] std::uint64_t num_triangles() const { return corners.size() - 2 * sizes.size(); }
};

/// Cuts every polygon into triangles and makes one vertex of every combination of position,
/// texture coordinate and normal that is used. A corner without a normal, in a mesh that has some,
/// gets that of its polygon; one without texture coordinates gets (0, 0), and its triangles are
/// counted. Indices are in range. Error{InvalidInput}: over `limits`, or polygons that are not
/// convex have too many corners.
[[nodiscard]] Result<TriangleMesh> triangle_mesh(PolygonMesh mesh, const MeshLimits& limits);

}  // namespace bouguer::renderer
