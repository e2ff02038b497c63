// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/mesh_file.h"

#include <algorithm>
#include <limits>
#include <new>
#include <string>
#include <utility>

#include "renderer/core/out_of_memory.h"
#include "renderer/geometry/mesh_readers.h"
#include "renderer/geometry/mesh_text.h"
#include "renderer/geometry/polygon_triangulation.h"

namespace bouguer::renderer {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// Whether a triangle has corners that differ and an area above the rounding of its edges.
bool has_area(const TriangleMesh& mesh, const Corners& corners) {
    Vec3 ab = mesh.positions[corners[1]] - mesh.positions[corners[0]];
    Vec3 ac = mesh.positions[corners[2]] - mesh.positions[corners[0]];
    const Real size = std::max(max_abs(ab), max_abs(ac));
    ab = ab / size;
    ac = ac / size;
    return length(cross(ab, ac)) > 1e-14 * length(ab) * length(ac);
}

std::string numbered(const char* what, std::size_t i) {
    return std::string(what) + " " + std::to_string(i);
}

Result<void> check_sizes(const TriangleMesh& mesh, const MeshLimits& limits) {
    const std::size_t n = mesh.positions.size();
    if (n > limits.max_vertices || n > std::numeric_limits<std::uint32_t>::max()) {
        return refuse_mesh("", "more vertices than allowed");
    }
    if (mesh.triangles.size() > limits.max_triangles) {
        return refuse_mesh("", "more triangles than allowed");
    }
    if (!mesh.normals.empty() && mesh.normals.size() != n) {
        return refuse_mesh("", "the number of normals is not that of positions");
    }
    if (!mesh.uvs.empty() && mesh.uvs.size() != n) {
        return refuse_mesh("", "the number of texture coordinates is not that of positions");
    }
    return {};
}

Result<void> check_values(const TriangleMesh& mesh) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (!is_finite(mesh.positions[i])) return refuse_mesh(numbered("vertex", i), "not finite");
    }
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        if (!is_finite(mesh.normals[i])) return refuse_mesh(numbered("normal", i), "not finite");
    }
    for (std::size_t i = 0; i < mesh.uvs.size(); ++i) {
        if (!std::isfinite(mesh.uvs[i].x) || !std::isfinite(mesh.uvs[i].y)) {
            return refuse_mesh(numbered("texture coordinate", i), "not finite");
        }
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (const std::uint32_t corner : mesh.triangles[i]) {
            if (corner >= mesh.positions.size()) {
                return refuse_mesh(numbered("triangle", i),
                                   "no such vertex: " + std::to_string(corner));
            }
        }
    }
    return {};
}

/// Takes out triangles without an area; those of three corners are kept aside.
void drop_flat_triangles(TriangleMesh& mesh) {
    auto kept = mesh.triangles.begin();
    for (const Corners& c : mesh.triangles) {
        if (has_area(mesh, c)) {
            *kept++ = c;
            continue;
        }
        ++mesh.dropped_triangles;
        const auto at = [&](std::size_t i) { return mesh.positions[c[i]]; };
        if (at(0) != at(1) && at(1) != at(2) && at(2) != at(0)) mesh.flat_triangles.push_back(c);
    }
    mesh.triangles.erase(kept, mesh.triangles.end());
}

/// The length of a normal says nothing about its direction; one of no length says nothing at all,
/// and becomes the mean of the triangles around its vertex.
void make_normals_unit(TriangleMesh& mesh) {
    bool lacks_some = false;
    std::vector<bool> is_given(mesh.normals.size(), true);
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        Vec3& n = mesh.normals[i];
        const Real size = max_abs(n);
        is_given[i] = size > 0;
        lacks_some = lacks_some || size == 0;
        if (size > 0) n = normalize(n / size);
    }
    if (!lacks_some) return;
    for (const Corners& c : mesh.triangles) {
        const std::array<Vec3, 3> p{mesh.positions[c[0]], mesh.positions[c[1]],
                                    mesh.positions[c[2]]};
        const Vec3 area = area_vector(p);
        for (const std::uint32_t i : c) {
            if (!is_given[i]) mesh.normals[i] += normalize(area);
        }
    }
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        Vec3& n = mesh.normals[i];
        if (!is_given[i] && length(n) > 0) n = normalize(n);
    }
}

}  // namespace

Result<std::shared_ptr<const TriangleMesh>> checked_mesh(TriangleMesh mesh,
                                                         const MeshLimits& limits) {
    auto checked = check_sizes(mesh, limits);
    if (checked) checked = check_values(mesh);
    if (!checked) return tl::unexpected<Error>(std::move(checked.error()));
    drop_flat_triangles(mesh);
    if (mesh.triangles.empty()) return refuse_mesh("", "no triangle that has an area");
    make_normals_unit(mesh);
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

Result<std::shared_ptr<const TriangleMesh>> read_mesh(std::string_view bytes,
                                                      const MeshLimits& limits) {
    try {
        auto mesh = is_ply(bytes) ? read_ply(bytes, limits) : read_obj(bytes, limits);
        if (!mesh) return tl::unexpected<Error>(std::move(mesh.error()));
        return checked_mesh(std::move(*mesh), limits);
    } catch (const std::bad_alloc&) {
        return out_of_memory();
    }
}

}  // namespace bouguer::renderer
