// SPDX-License-Identifier: Apache-2.0
// Reflectances from colours: a smooth spectrum of three numbers [Jakob and Hanika 2019].
#pragma once

#include <array>

#include "renderer/spectrum/spectrum.h"

namespace bouguer::renderer {

/// S(c0 t^2 + c1 t + c2) with the sigmoid S(x) = 1/2 + x / (2 sqrt(1 + x^2)) and t in [0, 1] over
/// the rendered range; always within [0, 1].
class SmoothReflectance final : public Spectrum {
  public:
    explicit SmoothReflectance(const std::array<double, 3>& coefficients) : c_(coefficients) {}
    [[nodiscard]] double at(double lambda_nm) const override;

  private:
    std::array<double, 3> c_;
};

/// Linear Rec.709 of a reflectance's colour under D65, each channel relative to D65's own, so that
/// a reflectance of 1 is exactly (1, 1, 1). Components may be negative.
std::array<double, 3> rec709_of_reflectance(const Spectrum& reflectance);

/// The coefficients whose rec709_of_reflectance() is nearest to `linear_rgb`, components in [0, 1]
/// and not all equal: Gauss-Newton on CIE L*a*b* with damping, led from grey to the colour in steps
/// so that the most saturated colours converge too. About 0.2 ms. Thread-safe.
std::array<double, 3> fit_smooth_reflectance(const std::array<double, 3>& linear_rgb);

/// CIEDE2000 of two linear Rec.709 colours, white (1, 1, 1).
double delta_e_2000(const std::array<double, 3>& linear_a, const std::array<double, 3>& linear_b);

}  // namespace bouguer::renderer
