// SPDX-License-Identifier: Apache-2.0
// libFuzzer entry for the mesh readers: whatever the bytes, a mesh that keeps its promises or an
// error. Build and run with clang and its runtime library (libclang-rt-14-dev), from the root:
//
//     clang++ -std=c++20 -O1 -g -fsanitize=fuzzer,address,undefined -I. tests/fuzz/mesh_fuzz.cpp
//         renderer/geometry/{mesh_file,mesh_size,obj_reader,ply_header,ply_reader}.cpp -o mesh_fuzz
//     ./mesh_fuzz -max_total_time=300 -malloc_limit_mb=256
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "renderer/geometry/mesh_file.h"
#include "renderer/geometry/mesh_size.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t length) {
    using namespace bouguer::renderer;
    const MeshLimits limits{10'000, 10'000};
    const auto mesh = read_mesh({reinterpret_cast<const char*>(data), length}, limits);
    if (!mesh) return 0;
    const TriangleMesh& m = **mesh;
    const std::size_t n = m.positions.size();
    bool good = n <= limits.max_vertices && m.triangles.size() <= limits.max_triangles &&
                !m.triangles.empty() && (m.normals.empty() || m.normals.size() == n) &&
                (m.uvs.empty() || m.uvs.size() == n);
    for (const Vec3& p : m.positions) good = good && is_finite(p);
    for (const auto& corners : m.triangles) {
        for (const std::uint32_t c : corners) good = good && c < n;
    }
    // Files are judged by this before they are read: it must accept them and promise no more.
    const auto size =
        read_mesh_size(MemorySource({reinterpret_cast<const char*>(data), length}), limits);
    good = good && size && size->triangles <= m.triangles.size() + m.dropped_triangles;
    if (!good) std::abort();
    return 0;
}
