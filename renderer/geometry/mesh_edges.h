// SPDX-License-Identifier: Apache-2.0
// The edges of a mesh and the triangles at each.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/core/vec3.h"

namespace bouguer::renderer {

/// One side of a triangle; `runs_up` tells whether its corners go from the lower to the higher of
/// its vertices.
struct TriangleSide {
    std::uint32_t low = 0, high = 0, triangle = 0;
    bool runs_up = false;
    [[nodiscard]] bool is_at_edge_of(const TriangleSide& other) const {
        return low == other.low && high == other.high;
    }
};

/// For every position the first of those that equal it.
[[nodiscard]] std::vector<std::uint32_t> welded(const std::vector<Vec3>& positions);

/// The sides of those triangles that are `kept`, one edge after the other. `triangles` have welded
/// vertices, below `vertices`.
[[nodiscard]] std::vector<TriangleSide> sorted_sides(
    const std::vector<std::array<std::uint32_t, 3>>& triangles, const std::vector<bool>& kept,
    std::size_t vertices);

/// Calls f with the sides at each edge.
template <class Function>
void for_each_edge(const std::vector<TriangleSide>& sides, const Function& f) {
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t end = i;
        while (end < sides.size() && sides[end].is_at_edge_of(sides[i])) ++end;
        f(std::span(sides).subspan(i, end - i));
        i = end;
    }
}

}  // namespace bouguer::renderer
