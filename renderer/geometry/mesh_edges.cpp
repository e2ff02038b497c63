// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/mesh_edges.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>

namespace bouguer::renderer {

std::vector<std::uint32_t> welded(const std::vector<Vec3>& positions) {
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const Vec3& p = positions[a];
        const Vec3& q = positions[b];
        if (p.x != q.x) return p.x < q.x;
        return std::tie(p.y, p.z, a) < std::tie(q.y, q.z, b);
    });
    std::vector<std::uint32_t> first(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool is_same = i > 0 && positions[order[i]] == positions[order[i - 1]];
        first[order[i]] = is_same ? first[order[i - 1]] : order[i];
    }
    return first;
}

std::vector<TriangleSide> sorted_sides(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                       const std::vector<bool>& kept, std::size_t vertices) {
    const auto for_each_side = [&](const auto& f) {
        for (std::uint32_t t = 0; t < triangles.size(); ++t) {
            if (!kept[t]) continue;
            for (std::size_t k = 0; k < 3; ++k) f(t, triangles[t][k], triangles[t][(k + 1) % 3]);
        }
    };
    // Into a bucket for each lower vertex, then by the higher one.
    std::vector<std::size_t> ends(vertices + 1);
    for_each_side(
        [&](std::uint32_t /*t*/, std::uint32_t a, std::uint32_t b) { ++ends[std::min(a, b) + 1]; });
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<TriangleSide> sides(ends.back());
    for_each_side([&](std::uint32_t t, std::uint32_t a, std::uint32_t b) {
        sides[ends[std::min(a, b)]++] = {std::min(a, b), std::max(a, b), t, a < b};
    });
    std::size_t begin = 0;
    for (std::size_t v = 0; v < vertices; ++v) {
        std::sort(sides.begin() + static_cast<std::ptrdiff_t>(begin),
                  sides.begin() + static_cast<std::ptrdiff_t>(ends[v]),
                  [](const TriangleSide& a, const TriangleSide& b) {
                      return std::tie(a.high, a.triangle) < std::tie(b.high, b.triangle);
                  });
        begin = ends[v];
    }
    return sides;
}

}  // namespace bouguer::renderer
