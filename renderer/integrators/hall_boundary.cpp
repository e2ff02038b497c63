// SPDX-License-Identifier: Apache-2.0
#include "renderer/integrators/hall_boundary.h"

#include <cmath>

#include "renderer/media/refraction.h"

namespace bouguer::renderer {
namespace {

/// A direction nearly in the plane of the facet is lifted off it by 3 seconds of arc: what a ray
/// meets that creeps along the facets of a mesh is decided by the rounding of their corners.
Vec3 off_facet(Vec3 d, Vec3 ng) {
    constexpr Real kLeastCosine = 0x1p-16;
    const Real cosine = dot(d, ng);
    if (std::abs(cosine) >= kLeastCosine) return d;
    return normalize(d + (std::copysign(kLeastCosine, cosine) - cosine) * ng);
}

}  // namespace

const Surface* inside_of(const MediumStack& media, const HallTables& tables) {
    if (media.current() == MediumStack::kOutside) return nullptr;
    return &tables.surface_of(tables.bodies.object_of(media.current()));
}

Boundary boundary_of(const SurfacePoint& at, const MediumStack& media, const HallTables& tables) {
    if (at.is_sheet()) return {};
    const auto index = [&](const MediumStack& side) {
        const Surface* inside = inside_of(side, tables);
        return inside ? inside->ior : 1;
    };
    return {index(media), index(at.face.beyond), at.face.entering};
}

bool disperses(const MediumStack& media, const HallTables& tables) {
    const Surface* inside = inside_of(media, tables);
    return inside != nullptr && inside->dispersive_ior != nullptr;
}

Vec3 reflected_direction(Vec3 d, const SurfacePoint& at) {
    const Vec3 r = reflect(d, at.n);
    return off_facet(dot(r, at.ng) > 0 ? r : reflect(d, at.ng), at.ng);
}

std::optional<Vec3> refracted_direction(Vec3 d, const SurfacePoint& at, Real eta) {
    if (at.is_sheet()) return d;
    auto t = dot(d, at.n) < 0 ? refract(d, at.n, eta) : std::nullopt;
    if (!t || dot(*t, at.ng) >= 0) t = refract(d, at.ng, eta);
    if (t) t = off_facet(*t, at.ng);
    return t;
}

}  // namespace bouguer::renderer
