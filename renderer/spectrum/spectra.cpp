// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/spectra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

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
    void add_breaks(double low_nm, double high_nm, double step_nm,
                    std::vector<double>& breaks_nm) const override {
        base_->add_breaks(low_nm, high_nm, step_nm, breaks_nm);
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

/// The integral of a function that is smooth from `from` to `to` [Abramowitz and Stegun 1964,
/// table 25.4: Gauss's rule of five points, exact for polynomials of degree 9].
template <class Function>
double integrate_smooth(Function f, double from, double to) {
    constexpr std::array<double, 3> kAt{0, 0.538469310105683, 0.906179845938664};
    constexpr std::array<double, 3> kWeight{0.568888888888889, 0.478628670499366,
                                            0.236926885056189};
    const double middle = (from + to) / 2, half = (to - from) / 2;
    double sum = kWeight[0] * f(middle);
    for (std::size_t i = 1; i < kAt.size(); ++i)
        sum += kWeight[i] * (f(middle - half * kAt[i]) + f(middle + half * kAt[i]));
    return half * sum;
}

class ProductSpectrum final : public Spectrum {
  public:
    ProductSpectrum(SpectrumPtr a, SpectrumPtr b) : a_(std::move(a)), b_(std::move(b)) {}

    [[nodiscard]] double at(double lambda_nm) const override {
        return a_->at(lambda_nm) * b_->at(lambda_nm);
    }

    /// The mean of the product, which is not the product of the means where factors are narrow: two
    /// lines beside each other in one step have none in common.
    [[nodiscard]] double tent_mean(double lambda_nm, double step_nm) const override {
        std::vector<double> breaks;
        add_breaks(lambda_nm - step_nm, lambda_nm + step_nm, step_nm, breaks);
        if (breaks.empty()) return at(lambda_nm);
        breaks.push_back(lambda_nm);
        breaks.push_back(lambda_nm + step_nm);
        std::sort(breaks.begin(), breaks.end());
        const auto weighted = [&](double nm) {
            return at(nm) * (1 - std::abs(nm - lambda_nm) / step_nm) / step_nm;
        };
        double mean = 0, from = lambda_nm - step_nm;
        for (const double to : breaks) {
            if (to > from) mean += integrate_smooth(weighted, from, to);
            from = to;
        }
        return mean;
    }
    void add_breaks(double low_nm, double high_nm, double step_nm,
                    std::vector<double>& breaks_nm) const override {
        a_->add_breaks(low_nm, high_nm, step_nm, breaks_nm);
        b_->add_breaks(low_nm, high_nm, step_nm, breaks_nm);
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
