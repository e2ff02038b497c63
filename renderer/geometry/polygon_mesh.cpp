// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/polygon_mesh.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>

#include "renderer/core/hash.h"
#include "renderer/geometry/mesh_text.h"
#include "renderer/geometry/polygon_triangulation.h"

namespace bouguer::renderer {
namespace {

constexpr std::uint32_t kNone = PolygonCorner::kNone;

/// Of all polygons of a file that are not convex: some seconds.
constexpr std::uint64_t kMostSteps = 1'000'000'000;

/// Finds the vertex that was made of a corner. Nearly all positions have one vertex: only those
/// that have more are looked up in a table.
class VertexTable {
  public:
    explicit VertexTable(std::size_t positions) : first_(positions, kNone) {}

    /// The vertex of `key`; `next` when it is new.
    std::uint32_t find_or_add(const PolygonCorner& key, std::uint32_t next) {
        std::uint32_t& first = first_[key.v];
        if (first == kNone) {
            first = next;
            attributes_.push_back({key.vt, key.vn});
            return next;
        }
        if (attributes_[first] == std::pair{key.vt, key.vn}) return first;
        const auto [it, is_new] = others_.try_emplace(key, next);
        if (is_new) attributes_.push_back({key.vt, key.vn});
        return it->second;
    }

  private:
    struct HashCorner {
        std::size_t operator()(const PolygonCorner& c) const { return hash(c.v, c.vt, c.vn); }
    };

    std::vector<std::uint32_t> first_;                                 ///< by position
    std::vector<std::pair<std::uint32_t, std::uint32_t>> attributes_;  ///< by vertex
    std::unordered_map<PolygonCorner, std::uint32_t, HashCorner> others_;
};

class Assembler {
  public:
    Assembler(PolygonMesh mesh, const MeshLimits& limits)
        : in_(std::move(mesh)),
          max_vertices_(std::min<std::size_t>(limits.max_vertices, kNone - 1)),
          max_triangles_(limits.max_triangles),
          vertices_(in_.positions.size()) {
        const auto has = [&](std::uint32_t PolygonCorner::*index) {
            return std::any_of(in_.corners.begin(), in_.corners.end(),
                               [&](const PolygonCorner& c) { return c.*index != kNone; });
        };
        has_uvs_ = has(&PolygonCorner::vt);
        has_normals_ = has(&PolygonCorner::vn);
    }

    Result<TriangleMesh> run() {
        out_.notes = std::move(in_.notes);
        out_.dropped_triangles = in_.small_faces;
        if (in_.num_triangles() > max_triangles_)
            return refuse_mesh("", "more triangles than allowed");
        out_.triangles.reserve(in_.num_triangles());
        std::size_t first = 0;
        for (std::size_t i = 0; i < in_.sizes.size(); first += in_.sizes[i++]) {
            if (auto added = polygon(i, {in_.corners.data() + first, in_.sizes[i]}); !added)
                return tl::unexpected<Error>(std::move(added.error()));
        }
        return std::move(out_);
    }

  private:
    Result<void> polygon(std::size_t index, std::span<const PolygonCorner> corners) {
        points_.clear();
        for (const PolygonCorner& c : corners) points_.push_back(in_.positions[c.v]);
        cut_.clear();
        const PolygonFault fault = cutter_.cut(points_, cut_);
        if (fault == PolygonFault::TooManyCorners) {
            return refuse(index, "a face that is not convex has more than " +
                                     std::to_string(kMaxConcaveCorners) + " corners");
        }
        if (cutter_.steps() > kMostSteps)
            return refuse(index, "the faces that are not convex have too many corners");
        if (fault == PolygonFault::NotSimple) ++out_.notes.crossed_polygons;
        own_normal_ = kNone;
        bool lacks_uvs = false;
        for (const auto& triangle : cut_) {
            auto& made = out_.triangles.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) {
                const auto vertex = vertex_of(corners[triangle[k]], lacks_uvs);
                if (!vertex) return refuse_mesh("", "more vertices than allowed");
                made[k] = *vertex;
            }
        }
        if (lacks_uvs) out_.notes.triangles_without_uvs += cut_.size();
        return {};
    }

    std::optional<std::uint32_t> vertex_of(PolygonCorner key, bool& lacks_uvs) {
        if (has_uvs_ && key.vt == kNone) lacks_uvs = true;
        if (has_normals_ && !is_usable(key.vn)) key.vn = normal_of_polygon();
        const auto next = static_cast<std::uint32_t>(out_.positions.size());
        const std::uint32_t vertex = vertices_.find_or_add(key, next);
        if (vertex != next) return vertex;
        if (next >= max_vertices_) return std::nullopt;
        out_.positions.push_back(in_.positions[key.v]);
        if (has_uvs_) out_.uvs.push_back(key.vt == kNone ? Vec2{} : in_.uvs[key.vt]);
        if (has_normals_) out_.normals.push_back(in_.normals[key.vn]);
        return vertex;
    }

    /// One of no length says nothing.
    [[nodiscard]] bool is_usable(std::uint32_t vn) const {
        return vn != kNone && in_.normals[vn] != Vec3{};
    }

    std::uint32_t normal_of_polygon() {
        if (own_normal_ != kNone) return own_normal_;
        own_normal_ = static_cast<std::uint32_t>(in_.normals.size());
        in_.normals.push_back(area_vector(points_));
        return own_normal_;
    }

    [[nodiscard]] tl::unexpected<Error> refuse(std::size_t index, const std::string& what) const {
        return refuse_mesh(in_.lines.empty() ? "face " + std::to_string(index)
                                             : "line " + std::to_string(in_.lines[index]),
                           what);
    }

    PolygonMesh in_;
    std::size_t max_vertices_, max_triangles_;
    bool has_uvs_ = false, has_normals_ = false;
    TriangleMesh out_;
    VertexTable vertices_;
    PolygonCutter cutter_;
    std::vector<Vec3> points_;                  ///< of the polygon at hand
    std::vector<PolygonCutter::Triangle> cut_;  ///< its triangles
    std::uint32_t own_normal_ = kNone;          ///< of the polygon at hand, once it is needed
};

}  // namespace

Result<TriangleMesh> triangle_mesh(PolygonMesh mesh, const MeshLimits& limits) {
    return Assembler(std::move(mesh), limits).run();
}

}  // namespace bouguer::renderer
