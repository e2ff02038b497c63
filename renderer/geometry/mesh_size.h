// SPDX-License-Identifier: Apache-2.0
// How large the mesh in a file is, without making it.
#pragma once

#include <cstdint>

#include "renderer/core/byte_source.h"
#include "renderer/geometry/mesh_file.h"

namespace bouguer::renderer {

struct MeshSize {
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;

    /// Of memory that a built mesh takes, estimated from above.
    [[nodiscard]] std::uint64_t memory_bytes() const {
        // A triangle: its indices and its share of Embree's tree (with ROBUST about 100 to 180
        // bytes). A vertex: position, normal and uv in double, and Embree's single-precision copy.
        constexpr std::uint64_t kTriangleBytes = 200, kVertexBytes = 80;
        return triangles * kTriangleBytes + vertices * kVertexBytes;
    }
};

/// What read_mesh() will hold at least, and for most files just that: of a PLY from its header, a
/// triangle for every face; of an OBJ, which has no header, from its lines, read in pieces and not
/// kept. Errors are those of read_mesh() that can be seen so, and of `file`.
[[nodiscard]] Result<MeshSize> read_mesh_size(const ByteSource& file,
                                              const MeshLimits& limits = {});

}  // namespace bouguer::renderer
