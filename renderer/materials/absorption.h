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

/// Equation 1, T = t^b, as exp(b ln t): puts ln t for one scene unit, in [-1e30, 0], into `table`
/// and returns the number of the split row. t = 0 gets a logarithm so low that any b > 0 is opaque
/// while b = 0 still gives 1.
[[nodiscard]] std::size_t bind_absorption(const Absorption& absorption, const SpectralBasis& basis,
                                          SpectralTable& table);

}  // namespace bouguer::renderer
