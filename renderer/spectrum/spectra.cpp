// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/spectra.h"

#include <memory>
#include <utility>

namespace bouguer::renderer {
namespace {

/// The constant 1, which every constant is a multiple of.
class UnitSpectrum final : public Spectrum {
  public:
    [[nodiscard]] double at(double) const override { return 1; }
    [[nodiscard]] bool is_constant() const override { return true; }
};

class ScaledSpectrum final : public Spectrum {
  public:
    ScaledSpectrum(SpectrumPtr base, double factor) : base_(std::move(base)), factor_(factor) {}

    [[nodiscard]] double at(double lambda_nm) const override {
        return factor_ * base_->at(lambda_nm);
    }
    [[nodiscard]] bool is_constant() const override { return base_->is_constant(); }
    [[nodiscard]] Multiple as_multiple() const override {
        const Multiple inner = base_->as_multiple();
        return {inner.base, factor_ * inner.factor};
    }

  private:
    SpectrumPtr base_;
    double factor_;
};

}  // namespace

SpectrumPtr constant_spectrum(double value) {
    static const auto unit = std::make_shared<const UnitSpectrum>();
    return scaled_spectrum(unit, value);
}

SpectrumPtr scaled_spectrum(SpectrumPtr base, double factor) {
    return std::make_shared<ScaledSpectrum>(std::move(base), factor);
}

}  // namespace bouguer::renderer
