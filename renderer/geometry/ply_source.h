// SPDX-License-Identifier: Apache-2.0
// The body of a PLY file as a row of values, in text or binary.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "renderer/core/vec3.h"
#include "renderer/geometry/mesh_text.h"
#include "renderer/geometry/ply_header.h"

namespace bouguer::renderer {

static_assert(std::endian::native == std::endian::little, "binary values are read as they stand");

/// Takes values of a known type off the body of the file.
class TextSource {
  public:
    explicit TextSource(const PlyHeader& header) : words_(header.body, header.body_line) {}

    /// Empty: the file ends here, or what stands here is no such value.
    std::optional<Real> value(PlyType type) {
        const std::string_view word = words_.word();
        if (!is_integer(type)) return parse_number<Real>(word);
        const auto number = parse_number<std::int64_t>(word);
        if (!number) return std::nullopt;
        return static_cast<Real>(*number);
    }
    [[nodiscard]] std::string where() const {
        return "line " + std::to_string(words_.line_number());
    }
    [[nodiscard]] std::string_view rest() const { return words_.rest(); }

  private:
    WordScanner words_;
};

template <bool Swap>
class BinarySource {
  public:
    explicit BinarySource(const PlyHeader& header) : rest_(header.body) {}

    std::optional<Real> value(PlyType type) {
        const std::size_t size = size_of(type);
        if (rest_.size() < size) return std::nullopt;
        std::array<char, 8> bytes{};
        std::memcpy(bytes.data(), rest_.data(), size);
        if (Swap) std::reverse(bytes.data(), bytes.data() + size);
        rest_.remove_prefix(size);
        switch (type) {
            case PlyType::Int8:
                return as<std::int8_t>(bytes);
            case PlyType::Uint8:
                return as<std::uint8_t>(bytes);
            case PlyType::Int16:
                return as<std::int16_t>(bytes);
            case PlyType::Uint16:
                return as<std::uint16_t>(bytes);
            case PlyType::Int32:
                return as<std::int32_t>(bytes);
            case PlyType::Uint32:
                return as<std::uint32_t>(bytes);
            case PlyType::Float32:
                return as<float>(bytes);
            case PlyType::Float64:
                return as<double>(bytes);
        }
        return std::nullopt;
    }
    [[nodiscard]] std::string where() const { return {}; }
    [[nodiscard]] std::string_view rest() const { return rest_; }

  private:
    template <class T>
    static Real as(const std::array<char, 8>& bytes) {
        T value{};
        std::memcpy(&value, bytes.data(), sizeof(T));
        return static_cast<Real>(value);
    }

    std::string_view rest_;
};

}  // namespace bouguer::renderer
