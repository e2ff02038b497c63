// SPDX-License-Identifier: Apache-2.0
// Triangle meshes of a document: inline or by the name of a file.
//
//     { "type": "mesh", "positions": [[x, y, z], ...], "triangles": [[i, j, k], ...],
//       "normals": [[x, y, z], ...], "uvs": [[u, v], ...] }        normals and uvs: optional
//     { "type": "file", "path": "teapot.ply" }        or by its digest: asset_reader.h
#pragma once

#include <optional>

#include "api/json_reader.h"
#include "api/read_context.h"
#include "renderer/geometry/shape.h"

namespace bouguer::api {

/// The inline mesh of `reader`'s object. Empty after a report.
[[nodiscard]] std::optional<renderer::Shape> read_mesh_shape(JsonReader& reader,
                                                             const ReadContext& context);

/// The mesh in the PLY or OBJ file that is named. Empty after a report.
[[nodiscard]] std::optional<renderer::Shape> read_file_shape(JsonReader& reader,
                                                             const ReadContext& context);

}  // namespace bouguer::api
