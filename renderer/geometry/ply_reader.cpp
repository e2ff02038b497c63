// SPDX-License-Identifier: Apache-2.0
// The body of a PLY file: its vertices and faces.
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include "renderer/geometry/mesh_readers.h"
#include "renderer/geometry/mesh_text.h"
#include "renderer/geometry/ply_header.h"

namespace bouguer::renderer {
namespace {

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

/// Where the numbers of a vertex stand among its properties.
struct VertexLayout {
    std::array<std::size_t, 3> position{};
    std::optional<std::array<std::size_t, 3>> normal;
    std::optional<std::array<std::size_t, 2>> uv;
};

template <std::size_t N>
std::optional<std::array<std::size_t, N>> places(const PlyElement& element,
                                                 const std::array<std::string_view, N>& names) {
    std::array<std::size_t, N> found{};
    for (std::size_t i = 0; i < N; ++i) {
        const auto place = element.scalar(names[i]);
        if (!place) return std::nullopt;
        found[i] = *place;
    }
    return found;
}

std::optional<VertexLayout> layout_of(const PlyElement& element) {
    using Names = std::array<std::string_view, 2>;
    VertexLayout layout;
    const auto position = places<3>(element, {"x", "y", "z"});
    if (!position) return std::nullopt;
    layout.position = *position;
    layout.normal = places<3>(element, {"nx", "ny", "nz"});
    for (const Names& names : {Names{"u", "v"}, Names{"s", "t"}, Names{"texture_u", "texture_v"}}) {
        if (!layout.uv) layout.uv = places<2>(element, names);
    }
    return layout;
}

bool is_face_list(const PlyProperty& property) {
    return property.list_size && is_integer(property.type) &&
           (property.name == "vertex_indices" || property.name == "vertex_index");
}

template <class Source>
class BodyReader {
  public:
    BodyReader(const PlyHeader& header, const MeshLimits& limits)
        : header_(header), limits_(limits), source_(header) {}

    Result<TriangleMesh> read() {
        if (auto checked = check_elements(); !checked) {
            return tl::unexpected<Error>(std::move(checked.error()));
        }
        for (const PlyElement& element : header_.elements) {
            auto read = element.name == "vertex" ? vertices(element)
                        : element.name == "face" ? faces(element)
                                                 : others(element);
            if (!read) return tl::unexpected<Error>(std::move(read.error()));
        }
        const std::string_view rest = source_.rest();
        if (!std::all_of(rest.begin(), rest.end(), is_space)) {
            return refuse_mesh(source_.where(), "more follows the last element");
        }
        return std::move(mesh_);
    }

  private:
    /// That there are vertices and faces, and not too many, before anything is reserved.
    Result<void> check_elements() {
        bool has_faces = false;
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex") {
                num_vertices_ = element.count;
                const auto layout = layout_of(element);
                if (!layout) return refuse_mesh("element \"vertex\"", "x, y or z is missing");
                layout_ = *layout;
            } else if (element.name == "face") {
                has_faces =
                    std::any_of(element.properties.begin(), element.properties.end(), is_face_list);
            }
        }
        if (auto few = check_ply_counts(header_, limits_); !few) return few;
        if (num_vertices_ == 0) return refuse_mesh("", "no vertices");
        if (!has_faces) return refuse_mesh("", "no faces with a list \"vertex_indices\"");
        return {};
    }

    Result<void> vertices(const PlyElement& element) {
        mesh_.positions.reserve(element.count);
        if (layout_.normal) mesh_.normals.reserve(element.count);
        if (layout_.uv) mesh_.uvs.reserve(element.count);
        std::vector<Real> values(element.properties.size());
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (std::size_t k = 0; k < values.size(); ++k) {
                const auto value = property(element.properties[k]);
                if (!value) return refuse(element, i);
                values[k] = *value;
            }
            mesh_.positions.push_back(vec3(values, layout_.position));
            if (layout_.normal) mesh_.normals.push_back(vec3(values, *layout_.normal));
            if (layout_.uv)
                mesh_.uvs.push_back({values[(*layout_.uv)[0]], values[(*layout_.uv)[1]]});
        }
        return {};
    }

    static Vec3 vec3(const std::vector<Real>& values, const std::array<std::size_t, 3>& at) {
        return {values[at[0]], values[at[1]], values[at[2]]};
    }

    Result<void> faces(const PlyElement& element) {
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (const PlyProperty& p : element.properties) {
                if (!is_face_list(p)) {
                    if (!property(p)) return refuse(element, i);
                } else if (auto read = face(element, i, p); !read) {
                    return read;
                }
            }
        }
        return {};
    }

    /// A polygon as a fan about its first corner.
    Result<void> face(const PlyElement& element, std::uint64_t i, const PlyProperty& list) {
        const auto size = source_.value(*list.list_size);
        if (!size) return refuse(element, i);
        if (*size < 3) return refuse(element, i, "a face needs three corners");
        std::array<std::uint32_t, 3> fan{};
        for (Real k = 0; k < *size; ++k) {
            const auto index = source_.value(list.type);
            if (!index) return refuse(element, i);
            if (*index < 0 || *index >= static_cast<Real>(num_vertices_)) {
                return refuse(element, i, "no such vertex");
            }
            fan[k < 2 ? static_cast<std::size_t>(k) : 2] = static_cast<std::uint32_t>(*index);
            if (k < 2) continue;
            if (mesh_.triangles.size() >= limits_.max_triangles) {
                return refuse(element, i, "more triangles than allowed");
            }
            mesh_.triangles.push_back(fan);
            fan[1] = fan[2];
        }
        return {};
    }

    Result<void> others(const PlyElement& element) {
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (const PlyProperty& p : element.properties) {
                if (!property(p)) return refuse(element, i);
            }
        }
        return {};
    }

    /// The value of a property, or the length of a list, whose values are passed over.
    std::optional<Real> property(const PlyProperty& p) {
        const auto value = source_.value(p.list_size.value_or(p.type));
        if (!p.list_size || !value) return value;
        if (*value < 0) return std::nullopt;
        for (Real k = 0; k < *value; ++k) {
            if (!source_.value(p.type)) return std::nullopt;
        }
        return value;
    }

    tl::unexpected<Error> refuse(const PlyElement& element, std::uint64_t i,
                                 const std::string& what = {}) {
        const std::string cut = "the file is cut short";
        const std::string why = !what.empty()            ? what
                                : source_.rest().empty() ? cut
                                                         : std::string("not a value of its type");
        const std::string line = source_.where();
        return refuse_mesh(
            (line.empty() ? "" : line + ", ") + element.name + " " + std::to_string(i), why);
    }

    const PlyHeader& header_;
    MeshLimits limits_;
    Source source_;
    VertexLayout layout_;
    std::uint64_t num_vertices_ = 0;
    TriangleMesh mesh_;
};

}  // namespace

Result<TriangleMesh> read_ply(std::string_view bytes, const MeshLimits& limits) {
    const auto header = read_ply_header(bytes, bytes.size());
    if (!header) return tl::unexpected<Error>(header.error());
    switch (header->format) {
        case PlyFormat::LittleEndian:
            return BodyReader<BinarySource<false>>(*header, limits).read();
        case PlyFormat::BigEndian:
            return BodyReader<BinarySource<true>>(*header, limits).read();
        case PlyFormat::Ascii:
            break;
    }
    return BodyReader<TextSource>(*header, limits).read();
}

}  // namespace bouguer::renderer
