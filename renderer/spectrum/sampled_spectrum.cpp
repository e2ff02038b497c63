// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/sampled_spectrum.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

std::string shown(double value) {
    std::string text = std::to_string(value);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
    }
    return text;
}

void check_wavelengths(const std::vector<double>& wavelengths_nm, std::vector<Problem>& problems) {
    for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) {
        const std::string pointer = "/wavelengths_nm/" + std::to_string(i);
        const double w = wavelengths_nm[i];
        if (!std::isfinite(w) || w <= 0) {
            problems.push_back({pointer, std::isfinite(w) ? "out-of-range" : "not-finite",
                                "a wavelength must be a finite number above 0", shown(w),
                                "a number above 0"});
        } else if (i > 0 && !(w > wavelengths_nm[i - 1])) {
            const bool is_duplicate = w == wavelengths_nm[i - 1];
            problems.push_back(
                {pointer, is_duplicate ? "duplicate" : "not-increasing",
                 is_duplicate ? "this wavelength stands there twice" : "wavelengths must increase",
                 shown(w), "a number above " + shown(wavelengths_nm[i - 1])});
        }
    }
}

void check_values(const std::vector<double>& values, std::vector<Problem>& problems) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isfinite(values[i]) && values[i] >= 0) continue;
        problems.push_back({"/values/" + std::to_string(i),
                            std::isfinite(values[i]) ? "out-of-range" : "not-finite",
                            "a value must be finite and not negative", shown(values[i]),
                            "a number >= 0"});
    }
    if (values.size() < 2)
        problems.push_back({"/values", "too-few", "a sampled spectrum needs at least two samples",
                            std::to_string(values.size()), "two or more numbers"});
}

double least_spacing(const std::vector<double>& wavelengths_nm) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < wavelengths_nm.size(); ++i)
        least = std::min(least, wavelengths_nm[i] - wavelengths_nm[i - 1]);
    return least;
}

/// The spectrum, or every problem at once.
Result<SpectrumPtr> make_sampled(std::vector<double> wavelengths_nm, std::vector<double> values,
                                 std::vector<Problem> problems) {
    if (!problems.empty())
        return tl::unexpected<Error>(Error{
            ErrorKind::InvalidInput, "the samples are not a spectrum", std::move(problems), {}});
    return std::make_shared<SampledSpectrum>(std::move(wavelengths_nm), std::move(values));
}

}  // namespace

SampledSpectrum::SampledSpectrum(std::vector<double> wavelengths_nm, std::vector<double> values)
    : wavelengths_nm_(std::move(wavelengths_nm)),
      values_(std::move(values)),
      is_constant_(std::adjacent_find(values_.begin(), values_.end(), std::not_equal_to<>()) ==
                   values_.end()),
      spacing_nm_(least_spacing(wavelengths_nm_)) {}

double SampledSpectrum::at(double lambda_nm) const {
    const auto next = std::upper_bound(wavelengths_nm_.begin(), wavelengths_nm_.end(), lambda_nm);
    if (next == wavelengths_nm_.begin()) return values_.front();
    if (next == wavelengths_nm_.end()) return values_.back();
    const auto i = static_cast<std::size_t>(next - wavelengths_nm_.begin());
    // A transmittance near 1 loses its logarithm by a rounding.
    if (values_[i] == values_[i - 1]) return values_[i];
    const double t =
        (lambda_nm - wavelengths_nm_[i - 1]) / (wavelengths_nm_[i] - wavelengths_nm_[i - 1]);
    return (1 - t) * values_[i - 1] + t * values_[i];
}

bool SampledSpectrum::is_rough(double step_nm) const {
    // A hair of tolerance: samples at the step itself are seen by the nodes as they are.
    return !is_constant_ && spacing_nm_ <= step_nm * (1 - 1e-9);
}

double SampledSpectrum::tent_mean(double lambda_nm, double step_nm) const {
    if (!is_rough(step_nm)) return at(lambda_nm);
    const auto weighted = [&](double w) {
        return at(w) * (1 - std::abs(w - lambda_nm) / step_nm) / step_nm;
    };
    // Between a sample, the tip of the tent and its ends the integrand is a parabola at most:
    // Simpson's rule is exact.
    double integral = 0, from = lambda_nm - step_nm;
    const auto add_up_to = [&](double to) {
        if (!(to > from)) return;
        integral +=
            (to - from) / 6 * (weighted(from) + 4 * weighted((from + to) / 2) + weighted(to));
        from = to;
    };
    for (const double half_end : {lambda_nm, lambda_nm + step_nm}) {
        auto next = std::upper_bound(wavelengths_nm_.begin(), wavelengths_nm_.end(), from);
        for (; next != wavelengths_nm_.end() && *next < half_end; ++next) add_up_to(*next);
        add_up_to(half_end);
    }
    return std::max(integral, 0.0);
}

void SampledSpectrum::add_breaks(double low_nm, double high_nm,
                                 std::vector<double>& breaks_nm) const {
    if (is_constant_) return;
    auto next = std::upper_bound(wavelengths_nm_.begin(), wavelengths_nm_.end(), low_nm);
    for (; next != wavelengths_nm_.end() && *next < high_nm; ++next) breaks_nm.push_back(*next);
}

Result<SpectrumPtr> sampled_spectrum(std::vector<double> wavelengths_nm,
                                     std::vector<double> values) {
    std::vector<Problem> problems;
    check_wavelengths(wavelengths_nm, problems);
    check_values(values, problems);
    if (wavelengths_nm.size() != values.size())
        problems.push_back({"/values", "length-mismatch", "one value is needed for each wavelength",
                            std::to_string(values.size()),
                            std::to_string(wavelengths_nm.size()) + " numbers"});
    return make_sampled(std::move(wavelengths_nm), std::move(values), std::move(problems));
}

Result<SpectrumPtr> regular_spectrum(double first_nm, double step_nm, std::vector<double> values) {
    std::vector<Problem> problems;
    for (const auto& [pointer, value] : {std::pair{"/first_nm", first_nm}, {"/step_nm", step_nm}}) {
        if (std::isfinite(value) && value > 0) continue;
        problems.push_back({pointer, std::isfinite(value) ? "out-of-range" : "not-finite",
                            "must be a finite number above 0", shown(value), "a number above 0"});
    }
    check_values(values, problems);
    std::vector<double> wavelengths_nm(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        wavelengths_nm[i] = first_nm + static_cast<double>(i) * step_nm;
    if (problems.empty() && !(wavelengths_nm.back() > wavelengths_nm[wavelengths_nm.size() - 2] &&
                              std::isfinite(wavelengths_nm.back())))
        problems.push_back({"/step_nm", "out-of-range", "the wavelengths do not increase or end",
                            shown(step_nm), "a step that first_nm can be told apart from"});
    return make_sampled(std::move(wavelengths_nm), std::move(values), std::move(problems));
}

}  // namespace bouguer::renderer
