// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/narrow_spectrum.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "renderer/core/vec3.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

/// The mean under the tent of half width `h` about x is the second difference, over h^2, of a
/// function whose second derivative is the spectrum.
template <class SecondAntiderivative>
double tent_mean_of(SecondAntiderivative f, double x, double h) {
    return std::max(((f(x + h) - f(x)) - (f(x) - f(x - h))) / (h * h), 0.0);
}

}  // namespace

GaussianSpectrum::GaussianSpectrum(const GaussianSpectrum& a, const GaussianSpectrum& b) {
    // By shares, and the peak by logarithms: nothing overflows that is not itself too large.
    const double both_nm = std::hypot(a.sigma_nm_, b.sigma_nm_);
    const double share_a = a.sigma_nm_ / both_nm, share_b = b.sigma_nm_ / both_nm;
    const double apart = (a.center_nm_ - b.center_nm_) / both_nm;
    center_nm_ = a.center_nm_ * share_b * share_b + b.center_nm_ * share_a * share_a;
    sigma_nm_ = a.sigma_nm_ * share_b;
    peak_ = std::exp(std::log(a.peak_) + std::log(b.peak_) - 0.5 * apart * apart);
}

double GaussianSpectrum::at(double lambda_nm) const {
    const double z = (lambda_nm - center_nm_) / sigma_nm_;
    return peak_ * std::exp(-0.5 * z * z);
}

/// From sigma = step up the rectangle rule on samples is right to 3e-9 as it stands.
double GaussianSpectrum::tent_mean(double lambda_nm, double step_nm) const {
    if (!is_rough(step_nm)) return at(lambda_nm);
    if (std::abs(lambda_nm - center_nm_) > step_nm + 40 * sigma_nm_) return 0;
    const auto f = [this](double x) {
        const double d = x - center_nm_, z = d / sigma_nm_;
        const double area_below = 0.5 * std::erfc(-z / std::sqrt(2.0));
        return sigma_nm_ *
               (std::sqrt(2 * kPi) * d * area_below + sigma_nm_ * std::exp(-0.5 * z * z));
    };
    return peak_ * tent_mean_of(f, lambda_nm, step_nm);
}

/// At so many widths from the middle, pieces short enough for a bell.
void GaussianSpectrum::add_breaks(double low_nm, double high_nm,
                                  std::vector<double>& breaks_nm) const {
    for (const double z : {0.0, 0.75, 1.5, 2.25, 3.0, 4.0, 5.0, 6.5, 8.5}) {
        for (const double nm : {center_nm_ - z * sigma_nm_, center_nm_ + z * sigma_nm_})
            if (nm > low_nm && nm < high_nm) breaks_nm.push_back(nm);
    }
}

double LineSpectrum::at(double lambda_nm) const {
    return std::abs(lambda_nm - line_nm_) <= width_nm_ / 2 ? integral_ / width_nm_ : 0;
}

double LineSpectrum::tent_mean(double lambda_nm, double step_nm) const {
    if (std::abs(lambda_nm - line_nm_) >= step_nm + width_nm_ / 2) return 0;
    // Of a rectangle of area 1: 0 before it, a parabola in it, a straight line behind it.
    const auto f = [this](double x) {
        const double d = x - line_nm_, half = width_nm_ / 2;
        if (d <= -half) return 0.0;
        return d >= half ? d : (d + half) * (d + half) / (2 * width_nm_);
    };
    return integral_ * tent_mean_of(f, lambda_nm, step_nm);
}

void LineSpectrum::add_breaks(double low_nm, double high_nm, std::vector<double>& breaks_nm) const {
    for (const double nm : {line_nm_ - width_nm_ / 2, line_nm_ + width_nm_ / 2})
        if (nm > low_nm && nm < high_nm) breaks_nm.push_back(nm);
}

namespace {

/// A field that must be finite and above 0, or, for amounts, not below.
void check(const char* pointer, double value, bool may_be_zero, std::vector<Problem>& problems) {
    if (std::isfinite(value) && (may_be_zero ? value >= 0 : value > 0)) return;
    const std::string allowed = may_be_zero ? "a number >= 0" : "a number above 0";
    problems.push_back({pointer, std::isfinite(value) ? "out-of-range" : "not-finite",
                        "must be " + allowed, std::to_string(value), allowed});
}

tl::unexpected<Error> refuse(std::string message, std::vector<Problem> problems) {
    return tl::unexpected<Error>(
        Error{ErrorKind::InvalidInput, std::move(message), std::move(problems), {}});
}

}  // namespace

Result<SpectrumPtr> gaussian_spectrum(double center_nm, double fwhm_nm, double peak) {
    std::vector<Problem> problems;
    check("/center_nm", center_nm, false, problems);
    check("/fwhm_nm", fwhm_nm, false, problems);
    check("/peak", peak, true, problems);
    if (!problems.empty()) return refuse("not a gaussian", std::move(problems));
    const double sigma_nm = fwhm_nm / std::sqrt(8 * std::log(2.0));
    return std::make_shared<GaussianSpectrum>(center_nm, sigma_nm, peak);
}

Result<SpectrumPtr> line_spectrum(double line_nm, double width_nm, double integral) {
    std::vector<Problem> problems;
    check("/line_nm", line_nm, false, problems);
    check("/width_nm", width_nm, false, problems);
    check("/integral", integral, true, problems);
    if (!problems.empty()) return refuse("not a line", std::move(problems));
    return std::make_shared<LineSpectrum>(line_nm, width_nm, integral);
}

}  // namespace bouguer::renderer
