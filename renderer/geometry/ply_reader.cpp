// SPDX-License-Identifier: Apache-2.0
// The body of a PLY file: its vertices and faces.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "renderer/geometry/mesh_readers.h"
#include "renderer/geometry/mesh_text.h"
#include "renderer/geometry/ply_header.h"
#include "renderer/geometry/ply_layout.h"
#include "renderer/geometry/ply_source.h"
#include "renderer/geometry/polygon_mesh.h"

namespace bouguer::renderer {
namespace {

bool is_finite(Vec2 a) { return std::isfinite(a.x) && std::isfinite(a.y); }

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
        mesh_.uvs.insert(mesh_.uvs.end(), corner_uvs_.begin(), corner_uvs_.end());
        return triangle_mesh(std::move(mesh_), limits_);
    }

  private:
    /// That there are vertices and faces, and not too many, before anything is reserved.
    Result<void> check_elements() {
        const PlyElement* faces = nullptr;
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex") {
                num_vertices_ = element.count;
                const auto layout = vertex_layout(element);
                if (!layout) return refuse_mesh("element \"vertex\"", "x, y or z is missing");
                vertex_ = *layout;
                note_unread(element, vertex_, mesh_.notes.dropped);
            } else if (element.name == "face") {
                faces = &element;
            } else {
                mesh_.notes.dropped.add("elements " + quoted(element.name));
            }
        }
        if (auto few = check_ply_counts(header_, limits_); !few) return few;
        if (num_vertices_ == 0) return refuse_mesh("", "no vertices");
        const auto layout =
            faces != nullptr ? face_layout(*faces, vertex_.normal.has_value()) : std::nullopt;
        if (!layout) return refuse_mesh("", "no faces with a list \"vertex_indices\"");
        face_ = *layout;
        note_unread(*faces, face_, mesh_.notes.dropped);
        return {};
    }

    Result<void> vertices(const PlyElement& element) {
        mesh_.positions.reserve(element.count);
        if (vertex_.normal) mesh_.normals.reserve(element.count);
        if (vertex_.uv) mesh_.uvs.reserve(element.count);
        values_.resize(element.properties.size());
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (std::size_t k = 0; k < values_.size(); ++k) {
                const auto value = property(element.properties[k]);
                if (!value) return refuse(element, i);
                values_[k] = *value;
            }
            mesh_.positions.push_back(value_of(vertex_.position));
            if (vertex_.normal) mesh_.normals.push_back(value_of(*vertex_.normal));
            if (vertex_.uv)
                mesh_.uvs.push_back({values_[(*vertex_.uv)[0]], values_[(*vertex_.uv)[1]]});
            const bool is_good = is_finite(mesh_.positions.back()) &&
                                 (!vertex_.normal || is_finite(mesh_.normals.back())) &&
                                 (!vertex_.uv || is_finite(mesh_.uvs.back()));
            if (!is_good) return refuse(element, i, "not finite");
        }
        return {};
    }

    [[nodiscard]] Vec3 value_of(const std::array<std::size_t, 3>& at) const {
        return {values_[at[0]], values_[at[1]], values_[at[2]]};
    }

    Result<void> faces(const PlyElement& element) {
        values_.resize(element.properties.size());
        for (std::uint64_t i = 0; i < element.count; ++i) {
            const std::size_t first = mesh_.corners.size();
            uvs_.clear();
            for (std::size_t k = 0; k < values_.size(); ++k) {
                const PlyProperty& p = element.properties[k];
                if (k == face_.corners) {
                    if (auto read = corners(element, i, p); !read) return read;
                } else if (k == face_.uvs) {
                    if (auto read = uv_list(element, i, p); !read) return read;
                } else {
                    const auto value = property(p);
                    if (!value) return refuse(element, i);
                    values_[k] = *value;
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
            mesh_.corners.push_back({v, vertex_.uv ? v : PolygonCorner::kNone,
                                     vertex_.normal ? v : PolygonCorner::kNone});
            if (mesh_.corners.size() > 3 * limits_.max_triangles + 2 * mesh_.sizes.size())
                return refuse(element, i, "more triangles than allowed");
        }
        return {};
    }

    /// Into uvs_, in pairs.
    Result<void> uv_list(const PlyElement& element, std::uint64_t i, const PlyProperty& list) {
        const auto size = source_.value(*list.list_size);
        if (!size || *size < 0) return refuse(element, i);
        for (Real k = 0; k < *size; ++k) {
            const auto value = source_.value(list.type);
            if (!value) return refuse(element, i);
            if (!std::isfinite(*value)) return refuse(element, i, "not finite");
            uvs_.push_back(*value);
        }
        return {};
    }

    /// Makes a polygon of the corners from `first` on. What has fewer than three is no face: it is
    /// counted.
    Result<void> end_face(const PlyElement& element, std::uint64_t i, std::size_t first) {
        const std::size_t size = mesh_.corners.size() - first;
        if (size < 3) {
            mesh_.corners.resize(first);
            mesh_.notes.dropped.add("faces of one or two corners");
            ++mesh_.small_faces;
            return {};
        }
        if (auto read = corner_uvs(element, i, first); !read) return read;
        if (face_.normal) {
            const Vec3 n = value_of(*face_.normal);
            if (!is_finite(n)) return refuse(element, i, "not finite");
            for (std::size_t k = first; k < mesh_.corners.size(); ++k)
                mesh_.corners[k].vn = static_cast<std::uint32_t>(mesh_.normals.size());
            mesh_.normals.push_back(n);
        }
        if (face_.texture && values_[*face_.texture] != 0)
            mesh_.notes.dropped.add("numbers of textures: all faces have one");
        mesh_.sizes.push_back(static_cast<std::uint32_t>(size));
        if (mesh_.num_triangles() > limits_.max_triangles)
            return refuse(element, i, "more triangles than allowed");
        return {};
    }

    /// Gives the coordinates in uvs_ to the corners from `first` on.
    Result<void> corner_uvs(const PlyElement& element, std::uint64_t i, std::size_t first) {
        if (uvs_.empty()) return {};
        if (uvs_.size() != 2 * (mesh_.corners.size() - first))
            return refuse(element, i, "texture coordinates are not two a corner");
        // They come behind those of vertices, which may follow later.
        const std::uint64_t of_vertices = vertex_.uv ? num_vertices_ : 0;
        for (std::size_t k = 0; 2 * k < uvs_.size(); ++k) {
            mesh_.corners[first + k].vt =
                static_cast<std::uint32_t>(of_vertices + corner_uvs_.size());
            corner_uvs_.push_back({uvs_[2 * k], uvs_[2 * k + 1]});
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
    PlyVertexLayout vertex_;
    PlyFaceLayout face_;
    std::uint64_t num_vertices_ = 0;
    PolygonMesh mesh_;
    std::vector<Real> values_;      ///< of one vertex or face
    std::vector<Real> uvs_;         ///< of one face's corners
    std::vector<Vec2> corner_uvs_;  ///< of all faces'
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
