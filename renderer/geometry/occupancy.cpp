// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/occupancy.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bouguer::renderer {

Occupancy::Occupancy(const TriangleMesh& mesh) {
    constexpr double kMost = 64;
    count_ = static_cast<int>(
        std::clamp(std::sqrt(static_cast<double>(mesh.triangles.size())), 4.0, kMost));
    occupied_.resize(index(count_ - 1, count_ - 1, count_ - 1) + 1);
    for (const auto& corners : mesh.triangles) {
        for (const std::uint32_t i : corners) box_.add(mesh.positions[i]);
    }
    for (const auto& corners : mesh.triangles) {
        Bounds box;
        for (const std::uint32_t i : corners) box.add(mesh.positions[i]);
        const auto [x0, x1] = cells(0, box.lo.x, box.hi.x);
        const auto [y0, y1] = cells(1, box.lo.y, box.hi.y);
        const auto [z0, z1] = cells(2, box.lo.z, box.hi.z);
        for (int z = z0; z <= z1; ++z) {
            for (int y = y0; y <= y1; ++y) {
                for (int x = x0; x <= x1; ++x) occupied_[index(x, y, z)] = true;
            }
        }
    }
}

bool Occupancy::is_near(Vec3 p, Real reach) const {
    for (int axis = 0; axis < 3; ++axis) {
        if (p[axis] < box_.lo[axis] - reach || p[axis] > box_.hi[axis] + reach) return false;
    }
    const auto [x0, x1] = cells(0, p.x - reach, p.x + reach);
    const auto [y0, y1] = cells(1, p.y - reach, p.y + reach);
    const auto [z0, z1] = cells(2, p.z - reach, p.z + reach);
    for (int z = z0; z <= z1; ++z) {
        for (int y = y0; y <= y1; ++y) {
            for (int x = x0; x <= x1; ++x) {
                if (occupied_[index(x, y, z)]) return true;
            }
        }
    }
    return false;
}

std::pair<int, int> Occupancy::cells(int axis, Real lo, Real hi) const {
    const Real size = box_.hi[axis] - box_.lo[axis];
    if (!(size > 0)) return {0, count_ - 1};
    const auto cell = [&](Real x) {
        return static_cast<int>(
            std::clamp((x - box_.lo[axis]) / size * count_, 0.0, static_cast<double>(count_ - 1)));
    };
    return {cell(lo), cell(hi)};
}

}  // namespace bouguer::renderer
