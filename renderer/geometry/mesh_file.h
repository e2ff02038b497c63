// SPDX-License-Identifier: Apache-2.0
// Reads triangle meshes from the bytes of PLY and OBJ files.
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>

#include "renderer/core/result.h"
#include "renderer/geometry/shape.h"

namespace bouguer::renderer {

struct MeshLimits {
    std::size_t max_vertices = 50'000'000;
    std::size_t max_triangles = 50'000'000;
};

/// PLY (ascii, binary little and big endian: x y z, nx ny nz, texture coordinates by vertex or
/// corner, face lists) or OBJ (v, vt, vn, f), told apart by the first bytes. Polygons, convex or
/// not, become triangles; attributes by corner split vertices; what else a file has is named in
/// TriangleMesh::notes.
/// Error{InvalidInput} names the line or element: not a mesh, cut short, index out of range, not
/// finite, over `limits`. Nothing is allocated on the word of a header: memory stays within some
/// tens of times the size of `bytes`. Triangles of zero area are left out and counted. Thread-safe.
[[nodiscard]] Result<std::shared_ptr<const TriangleMesh>> read_mesh(std::string_view bytes,
                                                                    const MeshLimits& limits = {});

/// Checks a mesh that came from elsewhere (inline JSON) by the same rules and drops zero-area
/// triangles.
[[nodiscard]] Result<std::shared_ptr<const TriangleMesh>> checked_mesh(
    TriangleMesh mesh, const MeshLimits& limits = {});

}  // namespace bouguer::renderer
