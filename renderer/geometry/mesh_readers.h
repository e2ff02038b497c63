// SPDX-License-Identifier: Apache-2.0
// The readers behind read_mesh(), one a format.
#pragma once

#include <string_view>

#include "renderer/core/result.h"
#include "renderer/geometry/mesh_file.h"
#include "renderer/geometry/mesh_text.h"
#include "renderer/geometry/shape.h"

namespace bouguer::renderer {

/// Why a file is refused that is neither.
inline constexpr const char* kNoMeshFile = "not a PLY file, nor an OBJ file with faces";

/// Each returns a mesh with every index in range and within `limits`; positions may still be not
/// finite and triangles without area. Error{InvalidInput} names the line or element.
[[nodiscard]] Result<TriangleMesh> read_ply(std::string_view bytes, const MeshLimits& limits);
[[nodiscard]] Result<TriangleMesh> read_obj(std::string_view bytes, const MeshLimits& limits);

/// Whether a file that begins so says that it is a PLY.
[[nodiscard]] inline bool is_ply(std::string_view first_bytes) {
    first_bytes = without_mark(first_bytes);
    return first_bytes.size() > 3 && first_bytes.starts_with("ply") && is_space(first_bytes[3]);
}
/// Whether a file that begins so may be an OBJ, which has no magic number: text, of which the first
/// line that says something begins with a word of the format. `first_bytes` need not be whole
/// lines.
[[nodiscard]] bool may_be_obj(std::string_view first_bytes);

}  // namespace bouguer::renderer
