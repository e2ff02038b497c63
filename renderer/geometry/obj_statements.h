// SPDX-License-Identifier: Apache-2.0
// The words that lines of OBJ files begin with.
#pragma once

#include <cstdint>
#include <string_view>

namespace bouguer::renderer {

/// What a statement means for the surface.
enum class ObjStatement : std::uint8_t {
    Vertex,
    TextureVertex,
    Normal,
    Face,
    Material,
    Smoothing,
    Map,
    Nothing,  ///< does not change polygons
    Dropped   ///< is something that is left out, and named
};

struct ObjKeyword {
    std::string_view word;
    ObjStatement means;
    std::string_view of = {};  ///< what is dropped
};

/// Null: no statement of the format.
[[nodiscard]] const ObjKeyword* find_obj_keyword(std::string_view word);

}  // namespace bouguer::renderer
