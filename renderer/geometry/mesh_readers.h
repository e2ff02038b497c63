// SPDX-License-Identifier: Apache-2.0
// The readers behind read_mesh(), one a format.
#pragma once

#include <string_view>

#include "renderer/core/result.h"
#include "renderer/geometry/mesh_file.h"
#include "renderer/geometry/shape.h"

namespace bouguer::renderer {

/// Each returns a mesh with every index in range and within `limits`; positions may still be not
/// finite and triangles without area. Error{InvalidInput} names the line or element.
[[nodiscard]] Result<TriangleMesh> read_ply(std::string_view bytes, const MeshLimits& limits);
[[nodiscard]] Result<TriangleMesh> read_obj(std::string_view bytes, const MeshLimits& limits);

}  // namespace bouguer::renderer
