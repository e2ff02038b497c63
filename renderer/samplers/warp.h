// SPDX-License-Identifier: Apache-2.0
// From points of the unit square to directions and filter offsets, each with its density.
#pragma once

#include "renderer/core/vec3.h"
#include "renderer/settings.h"

namespace bouguer::renderer {

/// A direction about +z with density (n + 1) / (2 pi) cos^n, per solid angle; n = 1 is the
/// cosine-weighted hemisphere divided by pi. [PBR4ed §A.5.3 for n = 1; the general exponent by
/// inverting the distribution of the cosine]
[[nodiscard]] Vec3 sample_cosine_power(Vec2 u, Real n);
[[nodiscard]] inline Real cosine_power_pdf(Real cos_theta, Real n) {
    return cos_theta <= 0 ? 0 : (n + 1) / (2 * kPi) * std::pow(cos_theta, n);
}

/// A facet's normal about +z with density D cos, per solid angle, D being Beckmann's distribution
/// of rms slope m, exp(-tan^2 / m^2) / (pi m^2 cos^4) [Walter et al. 2007, eq. 28 and 29].
[[nodiscard]] Vec3 sample_beckmann(Vec2 u, Real m);

/// Likewise with Trowbridge and Reitz's distribution, c^2 / (pi (cos^2 (c^2 - 1) + 1)^2) [Walter et
/// al. 2007, eq. 35 and 36, there called GGX].
[[nodiscard]] Vec3 sample_trowbridge_reitz(Vec2 u, Real c);

/// In [-1, 1), with the density 1 - |x| of a tent.
[[nodiscard]] Real sample_tent(Real u);

/// An offset from the pixel's centre, in pixels, whose density is the filter itself (importance
/// sampling: every sample then has weight one) [Ernst et al. 2006]. The Gaussian has standard
/// deviation radius / 3 and is cut at the radius.
[[nodiscard]] Vec2 sample_filter(const Filter& filter, Vec2 u);

}  // namespace bouguer::renderer
