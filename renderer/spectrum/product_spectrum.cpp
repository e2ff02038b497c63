// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "renderer/spectrum/colour.h"
#include "renderer/spectrum/narrow_spectrum.h"
#include "renderer/spectrum/scaled_spectrum.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

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

/// Of two factors or more, none of them constant, a multiple or a product.
class ProductSpectrum final : public Spectrum {
  public:
    explicit ProductSpectrum(std::vector<SpectrumPtr> factors)
        : factors_(std::move(factors)), num_(static_cast<double>(factors_.size())) {}

    [[nodiscard]] double at(double lambda_nm) const override {
        double product = 1;
        for (const SpectrumPtr& factor : factors_) product *= factor->at(lambda_nm);
        return product;
    }

    /// The mean of the product, which is not the product of the means where factors are narrow: two
    /// lines beside each other in one step have none in common.
    [[nodiscard]] double tent_mean(double lambda_nm, double step_nm) const override {
        if (!is_rough(step_nm)) return at(lambda_nm);
        std::vector<double> ends;
        add_breaks(lambda_nm - step_nm, lambda_nm + step_nm, ends);
        ends.push_back(lambda_nm);
        ends.push_back(lambda_nm + step_nm);
        std::sort(ends.begin(), ends.end());
        const auto weighted = [&](double nm) {
            return at(nm) * (1 - std::abs(nm - lambda_nm) / step_nm) / step_nm;
        };
        // What many factors make of a piece is no polynomial of a low degree: it is cut further.
        const double longest_nm = 4 * step_nm / (num_ + 2);
        double mean = 0, from = lambda_nm - step_nm;
        for (const double end : ends) {
            if (!(end > from)) continue;
            const double cuts = std::ceil((end - from) / longest_nm), length = (end - from) / cuts;
            for (double cut = 0; cut < cuts; ++cut)
                mean += integrate_smooth(weighted, from + cut * length, from + (cut + 1) * length);
            from = end;
        }
        return mean;
    }

    /// Every factor may narrow the others.
    [[nodiscard]] bool is_rough(double step_nm) const override {
        return std::any_of(factors_.begin(), factors_.end(), [&](const SpectrumPtr& factor) {
            return factor->is_rough((num_ - 1) * step_nm);
        });
    }
    void add_breaks(double low_nm, double high_nm, std::vector<double>& breaks_nm) const override {
        for (const SpectrumPtr& factor : factors_) factor->add_breaks(low_nm, high_nm, breaks_nm);
    }

    [[nodiscard]] const std::vector<SpectrumPtr>& factors() const { return factors_; }

  private:
    std::vector<SpectrumPtr> factors_;
    double num_;
};

/// Takes a product apart, as far as it goes.
class Factors {
  public:
    void add(const SpectrumPtr& s) {
        if (const auto scaled = std::dynamic_pointer_cast<const ScaledSpectrum>(s)) {
            scale_ *= scaled->factor();
            add(scaled->base());
        } else if (const auto product = std::dynamic_pointer_cast<const ProductSpectrum>(s)) {
            for (const SpectrumPtr& factor : product->factors()) add(factor);
        } else if (const auto bell = std::dynamic_pointer_cast<const GaussianSpectrum>(s)) {
            bell_ = bell_ ? std::make_shared<const GaussianSpectrum>(*bell_, *bell) : bell;
        } else if (s->is_constant()) {
            scale_ *= s->at(kLambdaMin_nm);
        } else {
            others_.push_back(s);
        }
    }

    [[nodiscard]] SpectrumPtr product() && {
        if (bell_) others_.push_back(std::move(bell_));
        if (others_.empty()) return constant_spectrum(scale_);
        SpectrumPtr product = others_.front();
        if (others_.size() > 1) product = std::make_shared<ProductSpectrum>(std::move(others_));
        return scale_ == 1 ? product : scaled_spectrum(std::move(product), scale_);
    }

  private:
    double scale_ = 1;
    std::shared_ptr<const GaussianSpectrum> bell_;  ///< of all gaussians
    std::vector<SpectrumPtr> others_;
};

}  // namespace

SpectrumPtr product_spectrum(SpectrumPtr a, SpectrumPtr b) {
    Factors factors;
    factors.add(a);
    factors.add(b);
    return std::move(factors).product();
}

}  // namespace bouguer::renderer
