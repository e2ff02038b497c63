// SPDX-License-Identifier: Apache-2.0
// The shapes of a scene as plain data. Lengths in scene units; each is placed by its object's
// transform.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "renderer/core/transform.h"

namespace bouguer::renderer {

struct Sphere {
    Vec3 center;
    Real radius = 1;
};

/// Infinite; `normal` need not be unit but is not zero.
struct Plane {
    Vec3 point;
    Vec3 normal{0, 1, 0};
};

struct Disk {
    Vec3 center;
    Vec3 normal{0, 1, 0};
    Real radius = 1;
};

/// Axis-parallel; every component of `min` is below that of `max`.
struct Box {
    Vec3 min, max;
};

/// A closed cylinder: its side and both caps.
struct Cylinder {
    Vec3 from, to;
    Real radius = 1;
};

/// Triangles with shared vertices; counter-clockwise seen from outside. Immutable once shared.
struct TriangleMesh {
    std::vector<Vec3> positions;
    std::vector<Vec3> normals;  ///< for shading, one a position; or empty: faces are flat
    std::vector<Vec2> uvs;      ///< one a position; or empty
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::uint64_t dropped_triangles =
        0;  ///< of zero area or with equal corners, left out when the mesh was read
};

using Shape = std::variant<Sphere, Plane, Disk, Box, Cylinder, std::shared_ptr<const TriangleMesh>>;

/// A shape where it stands: once for every entry of `instances`.
struct PlacedShape {
    Shape shape;
    std::vector<Transform> instances{Transform{}};  ///< shape to world; invertible; not empty
};

}  // namespace bouguer::renderer
