// SPDX-License-Identifier: Apache-2.0
// Which properties of a PLY file's vertices and faces are read, by the names that writers give
// them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "renderer/geometry/ply_header.h"
#include "renderer/geometry/shape.h"

namespace bouguer::renderer {

/// Where the numbers of a vertex stand among its properties.
struct PlyVertexLayout {
    std::array<std::size_t, 3> position{};
    std::optional<std::array<std::size_t, 3>> normal;
    std::optional<std::array<std::size_t, 2>> uv;
};

/// Where what is read of a face stands among its properties.
struct PlyFaceLayout {
    std::size_t corners = 0;         ///< a list of vertices
    std::optional<std::size_t> uvs;  ///< a list, u v u v ..., of corners
    std::optional<std::array<std::size_t, 3>> normal;
    std::optional<std::size_t> texture;  ///< which of several pictures
};

/// Empty: x, y or z is missing.
[[nodiscard]] std::optional<PlyVertexLayout> vertex_layout(const PlyElement& vertex);

/// Empty: there is no list of vertices. `has_normals`: vertices have them, and faces need none.
[[nodiscard]] std::optional<PlyFaceLayout> face_layout(const PlyElement& face, bool has_normals);

/// Names what a file has beside what is read of it.
void note_unread(const PlyElement& vertex, const PlyVertexLayout& layout, NameList& dropped);
void note_unread(const PlyElement& face, const PlyFaceLayout& layout, NameList& dropped);

}  // namespace bouguer::renderer
