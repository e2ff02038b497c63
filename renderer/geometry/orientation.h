// SPDX-License-Identifier: Apache-2.0
// On which side of a line a point lies, without error.
#pragma once

#include "renderer/core/vec3.h"

namespace bouguer::renderer {

/// About twice the area of the triangle abc: above zero when its corners run counter-clockwise,
/// below when they run clockwise, zero exactly when they lie on a line. The sign is never wrong
/// [Shewchuk 1997, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
/// Predicates"], as long as products of coordinates neither overflow nor underflow.
[[nodiscard]] Real orientation(Vec2 a, Vec2 b, Vec2 c);

}  // namespace bouguer::renderer
