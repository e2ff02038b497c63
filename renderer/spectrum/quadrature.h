// SPDX-License-Identifier: Apache-2.0
// The rule by which spectra are integrated: one place, so that everything that should agree does.
#pragma once

#include <vector>

#include "renderer/spectrum/colour.h"

namespace bouguer::renderer {

/// A wavelength and what a spectral radiance of 1 there adds to XYZ.
struct QuadratureNode {
    double lambda_nm = 0;
    Xyz weight;
};

/// Rectangle rule on 360, 360 + step, ... <= 830 nm: the weight is colour-matching function x step
/// / the observer's y_integral_nm(). `step_nm` > 0; at 1 nm the Y weights sum to 1.
std::vector<QuadratureNode> quadrature(double step_nm,
                                       const Observer& observer = standard_observer());

}  // namespace bouguer::renderer
