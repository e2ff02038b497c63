// SPDX-License-Identifier: Apache-2.0
// Directions at an interface.
#pragma once

#include <optional>

#include "renderer/core/vec3.h"

namespace bouguer::renderer {

/// Mirror direction of the unit `d` (towards the surface) about the unit normal `n`.
[[nodiscard]] inline Vec3 reflect(Vec3 d, Vec3 n) { return normalize(d - 2 * dot(d, n) * n); }

/// Refracted direction of the unit `d` (towards the surface; `n` unit, against d), `eta` = index
/// before / index behind. Snell's law; empty at total reflection: sin^2 >= 1 is asked before any
/// root is drawn.
[[nodiscard]] inline std::optional<Vec3> refract(Vec3 d, Vec3 n, Real eta) {
    if (eta == 1) return d;  // exactly, at any angle
    const Real cos_i = -dot(d, n);
    const Real sin2_t = eta * eta * std::max(Real(0), 1 - cos_i * cos_i);
    if (sin2_t >= 1) return std::nullopt;
    return normalize(eta * d + (eta * cos_i - std::sqrt(1 - sin2_t)) * n);
}

}  // namespace bouguer::renderer
