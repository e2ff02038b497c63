// SPDX-License-Identifier: Apache-2.0
// The one wavelength that goes on where paths of different wavelengths part.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/core/vec3.h"
#include "renderer/spectrum/spectral_basis.h"

namespace bouguer::renderer {

struct WavelengthSample {
    std::size_t node = 0;           ///< which number of the basis goes on
    float inverse_probability = 1;  ///< its new weight; the other numbers end
    double lambda_nm = 0;           ///< for the index of refraction
};

/// Draws nodes of a quadrature in proportion to what they add to X + Y + Z. The wavelength is
/// spread about the node by the tent over which the node's values are means, so that a spectrum on
/// a wall is not a row of lines. Immutable and thread-safe.
class WavelengthSampler {
  public:
    /// A basis without wavelengths leaves nothing to draw: sample() must not be called then.
    explicit WavelengthSampler(const SpectralBasis& basis);

    /// `u` is uniform on [0, 1)^2.
    [[nodiscard]] WavelengthSample sample(Vec2 u) const;

  private:
    std::vector<double> nodes_nm_, cumulative_;  ///< probability of a node or one before it
    double step_nm_;
};

}  // namespace bouguer::renderer
