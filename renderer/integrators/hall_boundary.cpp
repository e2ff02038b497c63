// SPDX-License-Identifier: Apache-2.0
#include "renderer/integrators/hall_boundary.h"

#include "renderer/media/refraction.h"

namespace bouguer::renderer {

const Surface* inside_of(const MediumStack& media, const HallTables& tables) {
    if (media.innermost() == MediumStack::kOutside) return nullptr;
    return &tables.surface_of(static_cast<std::uint32_t>(media.innermost() >> 32U));
}

bool step_through(const SurfacePoint& at, MediumStack& media) {
    if (at.is_sheet) return true;
    if (at.entering) return media.enter(at.body);
    media.leave(at.body);
    return true;
}

bool began_inside(const SurfacePoint& at, MediumStack& media) {
    const bool inside = at.comes_out() && !media.holds(at.body);
    if (inside) media.enter(at.body);
    return inside;
}

Boundary boundary_of(const SurfacePoint& at, const MediumStack& media, const HallTables& tables) {
    if (at.is_sheet) return {};
    MediumStack beyond = media;
    static_cast<void>(step_through(at, beyond));
    const auto index = [&](const MediumStack& side) {
        const Surface* inside = inside_of(side, tables);
        return inside ? inside->ior : 1;
    };
    return {index(media), index(beyond), at.entering};
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
    if (at.is_sheet) return d;
    auto t = dot(d, at.n) < 0 ? refract(d, at.n, eta) : std::nullopt;
    if (!t || dot(*t, at.ng) >= 0) t = refract(d, at.ng, eta);
    return t;
}

}  // namespace bouguer::renderer
