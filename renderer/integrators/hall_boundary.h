// SPDX-License-Identifier: Apache-2.0
// Which bodies a ray is in, and where it goes at their boundaries.
#pragma once

#include <optional>

#include "renderer/integrators/hall_path.h"
#include "renderer/integrators/hall_tables.h"

namespace bouguer::renderer {

/// The surface of the body that `media` is inside of; null outside of all.
[[nodiscard]] const Surface* inside_of(const MediumStack& media, const HallTables& tables);

/// Changes `media` to the bodies around a ray that has gone through the surface. False: there are
/// more bodies inside each other than the stack can hold.
bool step_through(const SurfacePoint& at, MediumStack& media);

/// Whether the ray comes out of a body that it never entered; then it is put inside. It was there
/// from its origin on: the camera may stand in a body, and of two bodies that touch the second is
/// entered in the very point where the first is left.
bool began_inside(const SurfacePoint& at, MediumStack& media);

/// The two sides of the surface for a ray inside `media`; a sheet has air on both.
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
