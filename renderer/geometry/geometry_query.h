// SPDX-License-Identifier: Apache-2.0
// What a query carries through Embree to our callbacks: the ray in double precision and what has
// been found of it.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "renderer/geometry/analytic_shape.h"
#include "renderer/geometry/embree_api.h"
#include "renderer/geometry/geometry.h"
#include "renderer/geometry/mesh_part.h"

namespace bouguer::renderer {

struct GeometryData;

/// Embree's ray is this one from `shift` on, and a length t along it is (t - shift) * scale there.
struct GeometryQuery : EmbreeContext {
    GeometryQuery(const GeometryData& geometry, const Ray& r) : data(&geometry), ray(&r) {
        init_context(*this);
    }

    static constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
    static constexpr std::uint32_t kNoPart = ~0U;

    /// The same question, put to the scene of one mesh.
    [[nodiscard]] GeometryQuery of_part(std::uint32_t number) const {
        GeometryQuery query = *this;
        init_context(query);
        query.part = number;
        return query;
    }

    /// Takes `hit` in where it is asked for. True: a ray that only asks whether it is blocked need
    /// not go on.
    bool meets(const Hit& hit) {
        if (crossings == nullptr) return hit.t > 0 && hit.t < t_max - resolution_along(hit, ray->d);
        if (hit.t >= from && hit.t <= t_max) crossings->push_back(hit);
        return false;
    }

    const GeometryData* data;
    const Ray* ray;
    Real shift = 0, scale = 1;
    Real t_max = kInfinity;        ///< of rays that ask whether they are blocked, and of crossings
    std::uint32_t part = kNoPart;  ///< the mesh whose own scene is asked

    // The nearest surface that is not a triangle of Embree's main scene.
    Real best_t = kInfinity;
    CrossingRank best_rank = CrossingRank::Enters;
    std::uint32_t best_part = kNoPart;
    AnalyticHit best_shape;  ///< where the part is a shape
    Hit best_triangle;       ///< where it is a mesh
    bool is_alone = true;    ///< nothing else was seen to be as near

    // All crossings with from <= t <= t_max.
    std::vector<Hit>* crossings = nullptr;
    Real from = 0;
};

/// Sets the filter that meets every triangle which blocks a ray, or is crossed by it, in double.
void set_triangle_filter(RTCGeometry geometry);

}  // namespace bouguer::renderer
