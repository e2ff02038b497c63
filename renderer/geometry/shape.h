// SPDX-License-Identifier: Apache-2.0
// The shapes of a scene as plain data. Lengths in scene units; each is placed by its object's
// transform.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
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

/// Names that came up, each once; of very many the first, and of long ones the beginning.
class NameList {
  public:
    void add(std::string_view name);
    [[nodiscard]] bool empty() const { return names_.empty(); }
    /// In the order in which they came, with commas between; "..." stands for those left out.
    [[nodiscard]] std::string text() const;

  private:
    std::vector<std::string> names_;
    bool has_more_ = false;
};

/// What a mesh file had beside the triangles that were made of it.
struct MeshNotes {
    NameList materials;                       ///< that `usemtl` names
    NameList dropped;                         ///< kinds of things that were left out, in words
    std::uint64_t triangles_without_uvs = 0;  ///< in a mesh of which others have them
    std::uint64_t crossed_polygons = 0;       ///< whose border crosses itself
};

/// How the surface of a mesh hangs together, and what was mended (see mesh_topology.h).
struct MeshTopology {
    bool is_closed = false;               ///< has an inside
    bool is_one_sided = false;            ///< as a Moebius strip and a Klein bottle are
    std::uint64_t open_edges = 0;         ///< where the surface ends, or does not go on in pairs
    std::uint64_t flipped_triangles = 0;  ///< turned round, to wind as the others or outwards
    std::uint64_t doubled_triangles = 0;  ///< in the place of another; left out
};

/// Triangles with shared vertices; counter-clockwise seen from outside. Immutable once shared.
struct TriangleMesh {
    std::vector<Vec3> positions;
    std::vector<Vec3> normals;  ///< for shading, unit, one a position; or empty: faces are flat
    std::vector<Vec2> uvs;      ///< one a position; or empty
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::uint64_t dropped_triangles =
        0;  ///< of zero area or with equal corners, left out when the mesh was read
    /// Of those left out, the ones with three corners: no ray meets them, but where a corner lies
    /// on the edge of another triangle they close the gap (see mesh_topology.h).
    std::vector<std::array<std::uint32_t, 3>> flat_triangles;
    MeshNotes notes;
    std::optional<MeshTopology> topology;  ///< of a mesh that was mended
};

using Shape = std::variant<Sphere, Plane, Disk, Box, Cylinder, std::shared_ptr<const TriangleMesh>>;

/// A shape where it stands: once for every entry of `instances`.
struct PlacedShape {
    Shape shape;
    std::vector<Transform> instances{Transform{}};  ///< shape to world; invertible; not empty
};

}  // namespace bouguer::renderer
