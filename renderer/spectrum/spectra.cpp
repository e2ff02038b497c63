// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/spectra.h"

#include <memory>
#include <utility>

#include "renderer/spectrum/colour.h"

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
    [[nodiscard]] double tent_mean(double lambda_nm, double step_nm) const override {
        return factor_ * base_->tent_mean(lambda_nm, step_nm);
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

class ProductSpectrum final : public Spectrum {
  public:
    ProductSpectrum(SpectrumPtr a, SpectrumPtr b) : a_(std::move(a)), b_(std::move(b)) {}

    [[nodiscard]] double at(double lambda_nm) const override {
        return a_->at(lambda_nm) * b_->at(lambda_nm);
    }
    /// The product of the means: right when one of the two is smooth over a step.
    [[nodiscard]] double tent_mean(double lambda_nm, double step_nm) const override {
        return a_->tent_mean(lambda_nm, step_nm) * b_->tent_mean(lambda_nm, step_nm);
    }

  private:
    SpectrumPtr a_, b_;
};

}  // namespace

SpectrumPtr product_spectrum(SpectrumPtr a, SpectrumPtr b) {
    if (a->is_constant()) return scaled_spectrum(std::move(b), a->at(kLambdaMin_nm));
    if (b->is_constant()) return scaled_spectrum(std::move(a), b->at(kLambdaMin_nm));
    return std::make_shared<ProductSpectrum>(std::move(a), std::move(b));
}

SpectrumPtr constant_spectrum(double value) {
    static const auto unit = std::make_shared<const UnitSpectrum>();
    return scaled_spectrum(unit, value);
}

SpectrumPtr scaled_spectrum(SpectrumPtr base, double factor) {
    // A multiple of a multiple is one multiple: chains of them cost nothing.
    if (const auto scaled = std::dynamic_pointer_cast<const ScaledSpectrum>(base)) {
        return std::make_shared<ScaledSpectrum>(scaled->base(), factor * scaled->factor());
    }
    return std::make_shared<ScaledSpectrum>(std::move(base), factor);
}

}  // namespace bouguer::renderer
