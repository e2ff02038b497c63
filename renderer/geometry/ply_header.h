// SPDX-License-Identifier: Apache-2.0
// The header of a PLY file: which elements follow, and what each consists of.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/core/result.h"
#include "renderer/geometry/mesh_file.h"

namespace bouguer::renderer {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };
enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

/// Bytes of a value in the binary formats.
[[nodiscard]] std::size_t size_of(PlyType type);
[[nodiscard]] inline bool is_integer(PlyType type) { return type < PlyType::Float32; }

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;
    std::optional<PlyType> list_size;  ///< of a list: the type of its length
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    /// The place of a property that is not a list; empty when there is none of that name.
    [[nodiscard]] std::optional<std::size_t> scalar(std::string_view property) const;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
    std::string_view body;        ///< what follows the header
    std::uint64_t body_line = 1;  ///< the number of its first line
};

/// The header in the first `bytes` of a file of `file_bytes`. Error{InvalidInput} names the line.
/// Every element has properties, and no more elements than the body has room for: each takes at
/// least a byte.
[[nodiscard]] Result<PlyHeader> read_ply_header(std::string_view bytes, std::uint64_t file_bytes);

/// The number of elements of that name; 0 when there are none.
[[nodiscard]] std::uint64_t count_of(const PlyHeader& header, std::string_view element);

/// That there are no more vertices and faces than allowed. Error{InvalidInput}.
[[nodiscard]] Result<void> check_ply_counts(const PlyHeader& header, const MeshLimits& limits);

}  // namespace bouguer::renderer
