// SPDX-License-Identifier: Apache-2.0
// libFuzzer entry for the mesh readers and for what becomes of a mesh that light goes through:
// whatever the bytes, a mesh that keeps its promises or an error. Build and run with clang and its
// runtime library (libclang-rt-14-dev), from the root:
//
//     clang++ -std=c++20 -O1 -g -fsanitize=fuzzer,address,undefined -I. tests/fuzz/mesh_fuzz.cpp
//         renderer/geometry/{mesh_edges,mesh_file,mesh_nesting,mesh_size,mesh_topology,obj_reader,
//         obj_statements,orientation,ply_header,ply_layout,ply_reader,polygon_mesh,
//         polygon_triangulation,shape}.cpp
//         -o mesh_fuzz
//     ./mesh_fuzz -max_total_time=300 -malloc_limit_mb=256
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "renderer/geometry/mesh_file.h"
#include "renderer/geometry/mesh_size.h"
#include "renderer/geometry/mesh_topology.h"

namespace {

using namespace bouguer::renderer;

constexpr MeshLimits kLimits{10'000, 10'000};

bool is_in_range(const std::vector<std::array<std::uint32_t, 3>>& triangles, std::size_t n) {
    return std::all_of(triangles.begin(), triangles.end(), [&](const auto& corners) {
        return std::max({corners[0], corners[1], corners[2]}) < n;
    });
}

bool is_unit_or_nothing(Vec3 n) { return n == Vec3{} || std::abs(length(n) - 1) < 1e-12; }

bool is_sound(const TriangleMesh& m) {
    const std::size_t n = m.positions.size();
    return n <= kLimits.max_vertices && m.triangles.size() <= kLimits.max_triangles &&
           !m.triangles.empty() && (m.normals.empty() || m.normals.size() == n) &&
           (m.uvs.empty() || m.uvs.size() == n) && is_in_range(m.triangles, n) &&
           is_in_range(m.flat_triangles, n) &&
           std::all_of(m.positions.begin(), m.positions.end(), is_finite) &&
           std::all_of(m.normals.begin(), m.normals.end(), is_unit_or_nothing) &&
           m.notes.materials.text().size() < 3000 && m.notes.dropped.text().size() < 3000;
}

/// Mending leaves out doubled triangles and turns some, and finds nothing to mend in its own work.
bool mends(const std::shared_ptr<const TriangleMesh>& mesh) {
    const auto mended = mended_mesh(mesh);
    const MeshTopology& found = *mended->topology;
    TriangleMesh again = *mended;
    again.topology.reset();
    const auto twice = mended_mesh(std::make_shared<const TriangleMesh>(std::move(again)));
    return is_in_range(mended->triangles, mesh->positions.size()) &&
           mended->triangles.size() + found.doubled_triangles == mesh->triangles.size() &&
           found.flipped_triangles <= mended->triangles.size() &&
           (!found.is_closed || (found.open_edges == 0 && twice->topology->is_closed)) &&
           twice->topology->doubled_triangles == 0 &&
           (!found.is_closed || mesh->flat_triangles.size() > 0 ||
            twice->topology->flipped_triangles == 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t length) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), length);
    const auto mesh = read_mesh(bytes, kLimits);
    if (!mesh) return 0;
    // Files are judged by their size before they are read: it must accept them and promise no more.
    const auto size = read_mesh_size(MemorySource(std::string(bytes)), kLimits);
    const bool is_good = is_sound(**mesh) && mends(*mesh) && size &&
                         size->triangles <= (*mesh)->triangles.size() + (*mesh)->dropped_triangles;
    if (!is_good) std::abort();
    return 0;
}
