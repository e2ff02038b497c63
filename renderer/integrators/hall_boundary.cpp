// SPDX-License-Identifier: Apache-2.0
#include "renderer/integrators/hall_boundary.h"

#include "renderer/media/refraction.h"

namespace bouguer::renderer {

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
    return dot(r, at.ng) > 0 ? r : reflect(d, at.ng);
}

std::optional<Vec3> refracted_direction(Vec3 d, const SurfacePoint& at, Real eta) {
    if (at.is_sheet()) return d;
    auto t = dot(d, at.n) < 0 ? refract(d, at.n, eta) : std::nullopt;
    if (!t || dot(*t, at.ng) >= 0) t = refract(d, at.ng, eta);
    return t;
}

}  // namespace bouguer::renderer
