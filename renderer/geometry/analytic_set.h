// SPDX-License-Identifier: Apache-2.0
// All analytic shapes of a scene as one user geometry of Embree.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/geometry/analytic_shape.h"
#include "renderer/geometry/embree_api.h"

namespace bouguer::renderer {

/// Whose surface a part is.
struct PartOwner {
    std::uint32_t object = 0, instance = 0;
};

inline void set_owner(Hit& hit, std::size_t part, PartOwner owner) {
    hit.part = static_cast<std::uint32_t>(part);
    hit.object = owner.object;
    hit.instance = owner.instance;
}

/// Embree keeps a pointer to it: it must stay where it is, unchanged, while the scene lives.
struct AnalyticSet {
    std::vector<AnalyticShape> shapes;
    std::vector<PartOwner> owners;
    std::uint32_t first_part = 0;  ///< the number of shape 0 among all parts
    Real scale = 1;                ///< from scene units to Embree's
    Real margin = 0;               ///< what the shapes' boxes are widened by, scene units
};

/// `box` in Embree's numbers, widened by `margin`.
void write_bounds(RTCBounds& to, const Bounds& box, Real margin, Real scale);

/// Every query of a scene that holds this geometry must come with a GeometryQuery as its context,
/// and one ray at a time.
[[nodiscard]] GeometryHandle make_analytic_geometry(RTCDevice device, AnalyticSet& set);

}  // namespace bouguer::renderer
