// SPDX-License-Identifier: Apache-2.0
// A spectrum given by samples.
#pragma once

#include <utility>
#include <vector>

#include "renderer/spectrum/spectrum.h"

namespace bouguer::renderer {

/// Linear between samples, constant beyond the first and the last [CIE 15:2018: values that are not
/// published are taken to be those of the nearest wavelength that is].
class SampledSpectrum final : public Spectrum {
  public:
    /// At least one sample; wavelengths increase; values are finite. sampled_spectrum() checks.
    SampledSpectrum(std::vector<double> wavelengths_nm, std::vector<double> values);

    [[nodiscard]] double at(double lambda_nm) const override;
    /// at() where the samples stand a step apart or more; closer ones are averaged, exactly.
    [[nodiscard]] double tent_mean(double lambda_nm, double step_nm) const override;
    [[nodiscard]] bool is_rough(double step_nm) const override;
    void add_breaks(double low_nm, double high_nm, std::vector<double>& breaks_nm) const override;
    [[nodiscard]] bool is_constant() const override { return is_constant_; }

  private:
    std::vector<double> wavelengths_nm_, values_;
    bool is_constant_;
    double spacing_nm_;  ///< least distance of two samples
};

}  // namespace bouguer::renderer
