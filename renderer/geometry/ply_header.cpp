// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/ply_header.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "renderer/geometry/mesh_text.h"

namespace bouguer::renderer {
namespace {

constexpr std::size_t kMaxElements = 64;
constexpr std::size_t kMaxProperties = 256;

std::optional<PlyType> type_named(std::string_view name) {
    static constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypes{{
        {"char", PlyType::Int8},
        {"int8", PlyType::Int8},
        {"uchar", PlyType::Uint8},
        {"uint8", PlyType::Uint8},
        {"short", PlyType::Int16},
        {"int16", PlyType::Int16},
        {"ushort", PlyType::Uint16},
        {"uint16", PlyType::Uint16},
        {"int", PlyType::Int32},
        {"int32", PlyType::Int32},
        {"uint", PlyType::Uint32},
        {"uint32", PlyType::Uint32},
        {"float", PlyType::Float32},
        {"float32", PlyType::Float32},
        {"double", PlyType::Float64},
        {"float64", PlyType::Float64},
    }};
    const auto* it = std::find_if(kTypes.begin(), kTypes.end(),
                                  [&](const auto& type) { return type.first == name; });
    if (it == kTypes.end()) return std::nullopt;
    return it->second;
}

class HeaderReader {
  public:
    HeaderReader(std::string_view bytes, std::uint64_t file_bytes)
        : lines_(bytes), beyond_(file_bytes - std::min<std::uint64_t>(file_bytes, bytes.size())) {}

    Result<PlyHeader> read() {
        lines_.line();  // "ply", which brought us here
        bool has_format = false;
        for (;;) {
            line_ = lines_.line_number();
            const auto line = lines_.line();
            if (!line) return refuse("the header does not end");
            WordScanner words(*line);
            const std::string_view keyword = words.word();
            if (keyword == "end_header") break;
            Result<void> read;
            if (keyword == "format" && !has_format) {
                read = format(words);
                has_format = true;
            } else if (keyword == "element") {
                read = element(words);
            } else if (keyword == "property") {
                read = property(words);
            } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
                read = refuse("not expected in a header: " + quoted(keyword));
            }
            if (!read) return tl::unexpected<Error>(std::move(read.error()));
        }
        if (!has_format) return refuse("no format is given");
        header_.body = lines_.rest();
        header_.body_line = lines_.line_number();
        return check_room();
    }

  private:
    Result<void> format(WordScanner& words) {
        const std::string_view name = words.word();
        if (name == "ascii") {
            header_.format = PlyFormat::Ascii;
        } else if (name == "binary_little_endian") {
            header_.format = PlyFormat::LittleEndian;
        } else if (name == "binary_big_endian") {
            header_.format = PlyFormat::BigEndian;
        } else {
            return refuse("unknown format " + quoted(name));
        }
        if (const auto version = words.word(); version != "1.0") {
            return refuse("unknown version " + quoted(version));
        }
        return at_end(words);
    }

    Result<void> element(WordScanner& words) {
        PlyElement element;
        element.name = words.word();
        const std::string_view count = words.word();
        const auto number = parse_number<std::uint64_t>(count);
        if (element.name.empty() || !number) return refuse("not a count: " + quoted(count));
        element.count = *number;
        if (has_name(header_.elements, element.name)) {
            return refuse("a second element " + quoted(element.name));
        }
        if (header_.elements.size() >= kMaxElements) return refuse("too many kinds of elements");
        header_.elements.push_back(std::move(element));
        return at_end(words);
    }

    Result<void> property(WordScanner& words) {
        if (header_.elements.empty()) return refuse("a property before any element");
        auto& properties = header_.elements.back().properties;
        PlyProperty property;
        std::string_view type = words.word();
        if (type == "list") {
            const std::string_view size = words.word();
            property.list_size = type_named(size);
            if (!property.list_size || !is_integer(*property.list_size)) {
                return refuse("no type for a list's length: " + quoted(size));
            }
            type = words.word();
        }
        const auto known = type_named(type);
        if (!known) return refuse("unknown type " + quoted(type));
        property.type = *known;
        property.name = words.word();
        if (property.name.empty()) return refuse("a property without a name");
        if (has_name(properties, property.name)) {
            return refuse("a second property " + quoted(property.name));
        }
        if (properties.size() >= kMaxProperties) return refuse("too many properties");
        properties.push_back(std::move(property));
        return at_end(words);
    }

    template <class Named>
    static bool has_name(const std::vector<Named>& all, const std::string& name) {
        return std::any_of(all.begin(), all.end(),
                           [&](const Named& one) { return one.name == name; });
    }

    Result<void> at_end(WordScanner& words) {
        const std::string_view extra = words.word();
        if (extra.empty()) return {};
        return refuse("not expected: " + quoted(extra));
    }

    /// The least that the elements take, against what there is. A value in text takes a digit and a
    /// space, a list in any format at least its length.
    Result<PlyHeader> check_room() {
        std::uint64_t room = header_.body.size() + beyond_ + 1;
        for (const PlyElement& element : header_.elements) {
            if (element.count == 0) continue;
            if (element.properties.empty()) {
                return refuse_mesh("element " + quoted(element.name), "has no properties");
            }
            std::uint64_t least = 0;
            for (const PlyProperty& property : element.properties) {
                least += header_.format == PlyFormat::Ascii
                             ? 2
                             : size_of(property.list_size.value_or(property.type));
            }
            if (element.count > room / least) {
                return refuse_mesh("element " + quoted(element.name), "the file is cut short");
            }
            room -= element.count * least;
        }
        return std::move(header_);
    }

    [[nodiscard]] tl::unexpected<Error> refuse(const std::string& what) const {
        return refuse_mesh("line " + std::to_string(line_), what);
    }

    WordScanner lines_;
    std::uint64_t beyond_;  ///< bytes of the file that are not here
    std::uint64_t line_ = 1;
    PlyHeader header_;
};

}  // namespace

std::size_t size_of(PlyType type) {
    constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[static_cast<std::size_t>(type)];
}

std::optional<std::size_t> PlyElement::scalar(std::string_view property) const {
    for (std::size_t i = 0; i < properties.size(); ++i) {
        if (properties[i].name == property && !properties[i].list_size) return i;
    }
    return std::nullopt;
}

Result<PlyHeader> read_ply_header(std::string_view bytes, std::uint64_t file_bytes) {
    return HeaderReader(bytes, file_bytes).read();
}

std::uint64_t count_of(const PlyHeader& header, std::string_view element) {
    for (const PlyElement& one : header.elements) {
        if (one.name == element) return one.count;
    }
    return 0;
}

Result<void> check_ply_counts(const PlyHeader& header, const MeshLimits& limits) {
    if (count_of(header, "face") > limits.max_triangles) {
        return refuse_mesh("element \"face\"", "more triangles than allowed");
    }
    const std::uint64_t vertices = count_of(header, "vertex");
    if (vertices > limits.max_vertices || vertices > std::numeric_limits<std::uint32_t>::max()) {
        return refuse_mesh("element \"vertex\"", "more vertices than allowed");
    }
    return {};
}

}  // namespace bouguer::renderer
