// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/ply_layout.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/geometry/mesh_text.h"

namespace bouguer::renderer {
namespace {

template <std::size_t N>
using Names = std::array<std::string_view, N>;

constexpr Names<3> kNormal{"nx", "ny", "nz"};

/// Texture coordinates of vertices.
constexpr std::array kUv{Names<2>{"u", "v"},
                         Names<2>{"s", "t"},
                         Names<2>{"texture_u", "texture_v"},
                         Names<2>{"texture_s", "texture_t"},
                         Names<2>{"texcoord_u", "texcoord_v"},
                         Names<2>{"tu", "tv"}};

template <std::size_t N>
std::optional<std::array<std::size_t, N>> places(const PlyElement& element, const Names<N>& names) {
    std::array<std::size_t, N> found{};
    for (std::size_t i = 0; i < N; ++i) {
        const auto place = element.scalar(names[i]);
        if (!place) return std::nullopt;
        found[i] = *place;
    }
    return found;
}

std::optional<std::size_t> list_named(const PlyElement& element, const Names<2>& names) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const PlyProperty& property = element.properties[i];
        if (property.list_size &&
            std::find(names.begin(), names.end(), property.name) != names.end())
            return i;
    }
    return std::nullopt;
}

/// A property in words.
std::string words_for(const PlyElement& element, const PlyProperty& property) {
    constexpr std::array<std::string_view, 7> kColours{"red", "green", "blue", "alpha",
                                                       "r",   "g",     "b"};
    const bool is_colour =
        std::find(kColours.begin(), kColours.end(), property.name) != kColours.end() ||
        property.name.starts_with("diffuse_");
    if (is_colour) return element.name + " colours";
    if (std::find(kNormal.begin(), kNormal.end(), property.name) != kNormal.end())
        return element.name + " normals";
    return element.name + " property " + quoted(property.name);
}

void note_all_but(const std::vector<std::size_t>& read, const PlyElement& element,
                  NameList& dropped) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        if (std::find(read.begin(), read.end(), i) == read.end())
            dropped.add(words_for(element, element.properties[i]));
    }
}

}  // namespace

std::optional<PlyVertexLayout> vertex_layout(const PlyElement& vertex) {
    PlyVertexLayout layout;
    const auto position = places<3>(vertex, {"x", "y", "z"});
    if (!position) return std::nullopt;
    layout.position = *position;
    layout.normal = places(vertex, kNormal);
    for (const Names<2>& names : kUv) {
        if (!layout.uv) layout.uv = places(vertex, names);
    }
    return layout;
}

std::optional<PlyFaceLayout> face_layout(const PlyElement& face, bool has_normals) {
    PlyFaceLayout layout;
    const auto corners = list_named(face, {"vertex_indices", "vertex_index"});
    if (!corners || !is_integer(face.properties[*corners].type)) return std::nullopt;
    layout.corners = *corners;
    layout.uvs = list_named(face, {"texcoord", "texture_coordinates"});
    if (!has_normals) layout.normal = places(face, kNormal);
    layout.texture = face.scalar("texnumber");
    return layout;
}

void note_unread(const PlyElement& vertex, const PlyVertexLayout& layout, NameList& dropped) {
    std::vector<std::size_t> read(layout.position.begin(), layout.position.end());
    if (layout.normal) read.insert(read.end(), layout.normal->begin(), layout.normal->end());
    if (layout.uv) read.insert(read.end(), layout.uv->begin(), layout.uv->end());
    note_all_but(read, vertex, dropped);
}

void note_unread(const PlyElement& face, const PlyFaceLayout& layout, NameList& dropped) {
    std::vector<std::size_t> read{layout.corners};
    if (layout.uvs) read.push_back(*layout.uvs);
    if (layout.normal) read.insert(read.end(), layout.normal->begin(), layout.normal->end());
    if (layout.texture) read.push_back(*layout.texture);
    note_all_but(read, face, dropped);
}

}  // namespace bouguer::renderer
