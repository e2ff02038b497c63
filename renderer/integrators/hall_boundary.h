// SPDX-License-Identifier: Apache-2.0
// Where a ray goes at the boundary of bodies.
#pragma once

#include <optional>

#include "renderer/integrators/hall_path.h"

namespace bouguer::renderer {

/// The surface of the body that is where a ray inside `media` is; null outside of all.
[[nodiscard]] const Surface* inside_of(const MediumStack& media, const HallTables& tables);

/// The two sides of the surface for a ray inside `media`; a sheet has the same on both.
[[nodiscard]] Boundary boundary_of(const SurfacePoint& at, const MediumStack& media,
                                   const HallTables& tables);

[[nodiscard]] bool disperses(const MediumStack& media, const HallTables& tables);

/// Interpolated normals can send a ray to the wrong side of the real surface; then the geometric
/// normal decides. `d` is the ray's direction, towards the surface.
[[nodiscard]] Vec3 reflected_direction(Vec3 d, const SurfacePoint& at);
/// Empty: total reflection. `eta` is the index before over the index beyond; a sheet is gone
/// through straight.
[[nodiscard]] std::optional<Vec3> refracted_direction(Vec3 d, const SurfacePoint& at, Real eta);

}  // namespace bouguer::renderer
