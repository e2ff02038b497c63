// SPDX-License-Identifier: Apache-2.0
// Meshes that have an Embree scene of their own, in their own coordinates, as one user geometry:
// small ones in a large scene, which single precision of the scene's size would spoil, and those
// that stand in many places. Rays go over in double precision.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/geometry/analytic_set.h"
#include "renderer/geometry/embree_api.h"

namespace bouguer::renderer {

struct NestedMesh {
    std::uint32_t part = 0;    ///< which of the geometry's meshes
    RTCScene scene = nullptr;  ///< of the mesh's buffer; owned by the geometry
};

/// Embree keeps a pointer to it: it must stay where it is, unchanged, while the scene lives.
struct NestedMeshes {
    std::vector<NestedMesh> meshes;
    std::vector<Bounds> bounds;  ///< in the coordinates of rays
    Real scale = 1;              ///< from scene units to Embree's
    Real margin = 0;             ///< what the boxes are widened by, scene units
};

/// Every query of a scene that holds this geometry must come with a GeometryQuery as its context,
/// and one ray at a time.
[[nodiscard]] GeometryHandle make_nested_geometry(RTCDevice device, NestedMeshes& set);

}  // namespace bouguer::renderer
