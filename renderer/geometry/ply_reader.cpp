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
#include "renderer/geometry/polygon_mesh.h"

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

/// The names that writers give to texture coordinates.
using UvNames = std::array<std::string_view, 2>;
constexpr std::array kUvNames{UvNames{"u", "v"},
                              UvNames{"s", "t"},
                              UvNames{"texture_u", "texture_v"},
                              UvNames{"texture_s", "texture_t"},
                              UvNames{"texcoord_u", "texcoord_v"},
                              UvNames{"tu", "tv"}};

std::optional<VertexLayout> layout_of(const PlyElement& element) {
    VertexLayout layout;
    const auto position = places<3>(element, {"x", "y", "z"});
    if (!position) return std::nullopt;
    layout.position = *position;
    layout.normal = places<3>(element, {"nx", "ny", "nz"});
    for (const UvNames& names : kUvNames) {
        if (!layout.uv) layout.uv = places<2>(element, names);
    }
    return layout;
}

bool is_face_list(const PlyProperty& property) {
    return property.list_size && is_integer(property.type) &&
           (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Texture coordinates by corner, u v u v ..., as MeshLab and Blender write them.
bool is_uv_list(const PlyProperty& property) {
    return property.list_size &&
           (property.name == "texcoord" || property.name == "texture_coordinates");
}

/// What a property that is not read would have been, in words; empty for what says nothing about
/// the surface.
std::string dropped_name(std::string_view element, const PlyProperty& property) {
    constexpr std::array<std::string_view, 6> kColours{"red", "green", "blue", "r", "g", "b"};
    constexpr std::array<std::string_view, 5> kNothing{"texnumber", "flags", "quality", "alpha",
                                                       "intensity"};
    const auto is_in = [&](const auto& names) {
        return std::find(names.begin(), names.end(), property.name) != names.end();
    };
    if (is_in(kNothing)) return {};
    if (is_in(kColours) || property.name.starts_with("diffuse_"))
        return element == "face" ? "face colours" : "vertex colours";
    return std::string(element) + " property " + quoted(property.name);
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
        if (mesh_.sizes.empty()) return refuse_mesh("", "no face of three corners");
        mesh_.uvs.insert(mesh_.uvs.end(), list_uvs_.begin(), list_uvs_.end());
        return triangle_mesh(std::move(mesh_), limits_);
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
                note_dropped(element);
            } else if (element.name == "face") {
                has_faces =
                    std::any_of(element.properties.begin(), element.properties.end(), is_face_list);
                for (const PlyProperty& p : element.properties) {
                    if (!is_face_list(p) && !is_uv_list(p)) note_dropped(element.name, p);
                }
            } else {
                MeshNotes::note(mesh_.notes.dropped, "elements " + quoted(element.name));
            }
        }
        if (auto few = check_ply_counts(header_, limits_); !few) return few;
        if (num_vertices_ == 0) return refuse_mesh("", "no vertices");
        if (!has_faces) return refuse_mesh("", "no faces with a list \"vertex_indices\"");
        return {};
    }

    void note_dropped(std::string_view element, const PlyProperty& property) {
        const std::string name = dropped_name(element, property);
        if (!name.empty()) MeshNotes::note(mesh_.notes.dropped, name);
    }

    void note_dropped(const PlyElement& vertex) {
        const auto is_read = [&](std::size_t k) {
            const auto has = [&](const auto& at) {
                return std::find(at.begin(), at.end(), k) != at.end();
            };
            return has(layout_.position) || (layout_.normal && has(*layout_.normal)) ||
                   (layout_.uv && has(*layout_.uv));
        };
        for (std::size_t k = 0; k < vertex.properties.size(); ++k) {
            if (!is_read(k)) note_dropped(vertex.name, vertex.properties[k]);
        }
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
            const std::size_t first = mesh_.corners.size();
            uv_list_.clear();
            for (const PlyProperty& p : element.properties) {
                if (is_face_list(p)) {
                    if (auto read = corners(element, i, p); !read) return read;
                } else if (is_uv_list(p)) {
                    if (!numbers(p)) return refuse(element, i);
                } else if (!property(p)) {
                    return refuse(element, i);
                }
            }
            if (auto ended = end_face(element, i, first); !ended) return ended;
        }
        return {};
    }

    Result<void> corners(const PlyElement& element, std::uint64_t i, const PlyProperty& list) {
        const auto size = source_.value(*list.list_size);
        if (!size || *size < 0) return refuse(element, i);
        for (Real k = 0; k < *size; ++k) {
            const auto index = source_.value(list.type);
            if (!index) return refuse(element, i);
            if (*index < 0 || *index >= static_cast<Real>(num_vertices_)) {
                return refuse(element, i, "no such vertex");
            }
            const auto v = static_cast<std::uint32_t>(*index);
            mesh_.corners.push_back({v, layout_.uv ? v : PolygonCorner::kNone,
                                     layout_.normal ? v : PolygonCorner::kNone});
            if (mesh_.corners.size() > 3 * limits_.max_triangles + 2 * mesh_.sizes.size())
                return refuse(element, i, "more triangles than allowed");
        }
        return {};
    }

    /// Into uv_list_.
    bool numbers(const PlyProperty& list) {
        const auto size = source_.value(*list.list_size);
        if (!size || *size < 0) return false;
        for (Real k = 0; k < *size; ++k) {
            const auto value = source_.value(list.type);
            if (!value) return false;
            uv_list_.push_back(*value);
        }
        return true;
    }

    /// Joins the corners from `first` on to a polygon with the coordinates of uv_list_. What has
    /// fewer than three is no face: it is counted.
    Result<void> end_face(const PlyElement& element, std::uint64_t i, std::size_t first) {
        const std::size_t size = mesh_.corners.size() - first;
        if (size < 3) {
            mesh_.corners.resize(first);
            MeshNotes::note(mesh_.notes.dropped, "faces of one or two corners");
            return {};
        }
        if (!uv_list_.empty()) {
            if (uv_list_.size() != 2 * size)
                return refuse(element, i, "texture coordinates are not two a corner");
            for (std::size_t k = 0; k < size; ++k) {
                mesh_.corners[first + k].vt =
                    static_cast<std::uint32_t>(num_vertex_uvs() + list_uvs_.size());
                list_uvs_.push_back({uv_list_[2 * k], uv_list_[2 * k + 1]});
            }
        }
        mesh_.sizes.push_back(static_cast<std::uint32_t>(size));
        if (mesh_.num_triangles() > limits_.max_triangles)
            return refuse(element, i, "more triangles than allowed");
        return {};
    }

    /// Texture coordinates of faces stand behind those of vertices, which may come later.
    [[nodiscard]] std::uint64_t num_vertex_uvs() const { return layout_.uv ? num_vertices_ : 0; }

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
    PolygonMesh mesh_;
    std::vector<Real> uv_list_;   ///< of one face
    std::vector<Vec2> list_uvs_;  ///< of all faces
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
