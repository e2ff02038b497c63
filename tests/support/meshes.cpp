// SPDX-License-Identifier: Apache-2.0
#include "tests/support/meshes.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace bouguer::renderer::test {
namespace {

using Corners = std::array<std::uint32_t, 3>;

TriangleMesh icosahedron() {
    const Real g = (1 + std::sqrt(5.0)) / 2;
    TriangleMesh mesh;
    mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                      {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (Vec3& p : mesh.positions) p = normalize(p);
    mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    return mesh;
}

}  // namespace

std::shared_ptr<const TriangleMesh> icosphere(int levels, bool smooth) {
    TriangleMesh mesh = icosahedron();
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> midpoints;
        const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
            const auto [it, is_new] = midpoints.try_emplace(
                std::minmax(a, b), static_cast<std::uint32_t>(mesh.positions.size()));
            if (is_new) mesh.positions.push_back(normalize(mesh.positions[a] + mesh.positions[b]));
            return it->second;
        };
        std::vector<Corners> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const std::uint32_t ab = midpoint(a, b);
            const std::uint32_t bc = midpoint(b, c);
            const std::uint32_t ca = midpoint(c, a);
            for (const Corners& t : {Corners{a, ab, ca}, Corners{ab, b, bc}, Corners{ca, bc, c},
                                     Corners{ab, bc, ca}}) {
                finer.push_back(t);
            }
        }
        mesh.triangles = std::move(finer);
    }
    if (smooth) mesh.normals = mesh.positions;
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

std::shared_ptr<const TriangleMesh> cube() {
    TriangleMesh mesh;
    for (const Real z : {-1, 1}) {
        for (const Real y : {-1, 1}) {
            for (const Real x : {-1, 1}) mesh.positions.push_back({x, y, z});
        }
    }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

std::shared_ptr<const TriangleMesh> box_mesh(Vec3 min, Vec3 max) {
    TriangleMesh mesh = *cube();
    const auto between = [](Real lo, Real hi, Real x) { return x < 0 ? lo : hi; };
    for (Vec3& p : mesh.positions) {
        p = {between(min.x, max.x, p.x), between(min.y, max.y, p.y), between(min.z, max.z, p.z)};
    }
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

Shape box_or_mesh(bool is_mesh, Vec3 min, Vec3 max) {
    if (is_mesh) return box_mesh(min, max);
    return Box{min, max};
}

std::shared_ptr<const TriangleMesh> prism(Real radius, Real from_z, Real to_z, int sides,
                                          Real turn_rad) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, from_z}, {0, 0, to_z}};
    for (int i = 0; i < sides; ++i) {
        const Real phi = turn_rad + 2 * kPi * i / sides;
        for (const Real z : {from_z, to_z})
            mesh.positions.push_back({radius * std::cos(phi), radius * std::sin(phi), z});
    }
    for (int i = 0; i < sides; ++i) {
        const auto low = static_cast<std::uint32_t>(2 + 2 * i);
        const auto next = static_cast<std::uint32_t>(2 + 2 * ((i + 1) % sides));
        mesh.triangles.push_back({0, next, low});
        mesh.triangles.push_back({1, low + 1, next + 1});
        mesh.triangles.push_back({low, next, next + 1});
        mesh.triangles.push_back({low, next + 1, low + 1});
    }
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

std::shared_ptr<const TriangleMesh> torus(Real ring, Real tube, int around, int across) {
    TriangleMesh mesh;
    const auto index = [&](int i, int j) {
        return static_cast<std::uint32_t>((i % around) * across + j % across);
    };
    for (int i = 0; i < around; ++i) {
        const Real phi = 2 * kPi * i / around;
        for (int j = 0; j < across; ++j) {
            const Real theta = 2 * kPi * j / across;
            const Vec3 n{std::cos(theta) * std::cos(phi), std::cos(theta) * std::sin(phi),
                         std::sin(theta)};
            mesh.positions.push_back(Vec3{ring * std::cos(phi), ring * std::sin(phi), 0} +
                                     tube * n);
            mesh.normals.push_back(n);
            mesh.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
            mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
        }
    }
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

std::shared_ptr<const TriangleMesh> square(Real half) {
    TriangleMesh mesh;
    mesh.positions = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

}  // namespace bouguer::renderer::test
