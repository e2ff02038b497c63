// SPDX-License-Identifier: Apache-2.0
// A multiple of a spectrum.
#pragma once

#include <utility>
#include <vector>

#include "renderer/spectrum/spectrum.h"

namespace bouguer::renderer {

class ScaledSpectrum final : public Spectrum {
  public:
    ScaledSpectrum(SpectrumPtr base, double factor) : base_(std::move(base)), factor_(factor) {}

    [[nodiscard]] double at(double lambda_nm) const override {
        return factor_ * base_->at(lambda_nm);
    }
    [[nodiscard]] double tent_mean(double lambda_nm, double step_nm) const override {
        return factor_ * base_->tent_mean(lambda_nm, step_nm);
    }
    [[nodiscard]] bool is_rough(double step_nm) const override { return base_->is_rough(step_nm); }
    void add_breaks(double low_nm, double high_nm, std::vector<double>& breaks_nm) const override {
        base_->add_breaks(low_nm, high_nm, breaks_nm);
    }
    [[nodiscard]] bool is_constant() const override { return base_->is_constant(); }
    [[nodiscard]] Multiple as_multiple() const override {
        const Multiple inner = base_->as_multiple();
        return {inner.base, factor_ * inner.factor};
    }

    [[nodiscard]] const SpectrumPtr& base() const { return base_; }
    [[nodiscard]] double factor() const { return factor_; }

  private:
    SpectrumPtr base_;
    double factor_;
};

}  // namespace bouguer::renderer
