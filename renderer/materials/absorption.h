// SPDX-License-Identifier: Apache-2.0
// Bouguer-Beer absorption inside a body: equation 1 of [Lee et al.].
#pragma once

#include <cstddef>

#include "renderer/core/span_math.h"
#include "renderer/core/vec3.h"
#include "renderer/spectrum/spectral_basis.h"
#include "renderer/spectrum/spectrum.h"

namespace bouguer::renderer {

/// Internal transmittance after `thickness` scene units inside the object.
struct Absorption {
    SpectrumPtr transmittance;  ///< t, in [0, 1]
    Real thickness = 1;
};

/// ln t for one scene unit, in the numbers of one render.
struct BoundAbsorption {
    std::size_t log_t = 0;  ///< a split row, in [-1e30, 0]
    double steepest = 0;    ///< the largest optical depth of one scene unit, of what is not black
};

/// Equation 1, T = t^b, as exp(b ln t): puts ln t into `table`. t = 0 gets a logarithm so low that
/// any b > 0 is opaque while b = 0 still gives 1.
[[nodiscard]] BoundAbsorption bind_absorption(const Absorption& absorption,
                                              const SpectralBasis& basis, SpectralTable& table);

}  // namespace bouguer::renderer
