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

/// Embree keeps a pointer to it: it must stay where it is, unchanged, while the scene lives.
struct AnalyticSet {
    std::vector<AnalyticShape> shapes;
    std::vector<PartOwner> owners;
    Real scale = 1;   ///< from scene units to Embree's
    Real margin = 0;  ///< what the shapes' boxes are widened by, scene units
};

/// What a query carries to the analytic shapes: the ray in double precision, and the best so far.
struct AnalyticQuery : EmbreeContext {
    explicit AnalyticQuery(const Ray& r) : ray(&r) { init_context(*this); }

    const Ray* ray;
    Real shift = 0;  ///< where Embree's ray begins, along this one
    Real t_max = std::numeric_limits<Real>::infinity();  ///< used by occlusion queries
    AnalyticHit best;
    std::uint32_t best_shape = 0;
};

/// Every query of a scene that holds this geometry must come with an AnalyticQuery as its context,
/// and one ray at a time.
[[nodiscard]] GeometryHandle make_analytic_geometry(RTCDevice device, AnalyticSet& set);

}  // namespace bouguer::renderer
