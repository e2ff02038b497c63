// SPDX-License-Identifier: Apache-2.0
// Spectra that may be narrower than the distance of a quadrature's nodes: gaussians and lines.
#pragma once

#include <vector>

#include "renderer/spectrum/spectrum.h"

namespace bouguer::renderer {

/// peak exp(-(lambda - center)^2 / (2 sigma^2)). gaussian_spectrum() checks.
class GaussianSpectrum final : public Spectrum {
  public:
    GaussianSpectrum(double center_nm, double sigma_nm, double peak)
        : center_nm_(center_nm), sigma_nm_(sigma_nm), peak_(peak) {}
    /// The product of two, which is a gaussian.
    GaussianSpectrum(const GaussianSpectrum& a, const GaussianSpectrum& b);

    [[nodiscard]] double at(double lambda_nm) const override;
    [[nodiscard]] double tent_mean(double lambda_nm, double step_nm) const override;
    [[nodiscard]] bool is_rough(double step_nm) const override { return sigma_nm_ < step_nm; }
    void add_breaks(double low_nm, double high_nm, std::vector<double>& breaks_nm) const override;

  private:
    double center_nm_, sigma_nm_, peak_;
};

/// A rectangle. line_spectrum() checks.
class LineSpectrum final : public Spectrum {
  public:
    LineSpectrum(double line_nm, double width_nm, double integral)
        : line_nm_(line_nm), width_nm_(width_nm), integral_(integral) {}

    [[nodiscard]] double at(double lambda_nm) const override;
    [[nodiscard]] double tent_mean(double lambda_nm, double step_nm) const override;
    [[nodiscard]] bool is_rough(double /*step_nm*/) const override { return true; }
    void add_breaks(double low_nm, double high_nm, std::vector<double>& breaks_nm) const override;

  private:
    double line_nm_, width_nm_, integral_;
};

}  // namespace bouguer::renderer
