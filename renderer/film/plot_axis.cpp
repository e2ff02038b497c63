// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/plot_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace bouguer::renderer {
namespace {

constexpr double kMostSteps = 10;
constexpr double kFewDecades = 2.5;
/// Values beyond this (or, on a logarithmic axis, below one over it) do not count for a range.
constexpr double kLargest = 1e300;
/// Rounding may put the last tick a hair beyond the end.
constexpr double kHair = 1e-9;

/// "0.25", "400", "1e-05": as short as six digits allow.
std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", std::abs(value) < 1e-300 ? 0.0 : value);
    return text.data();
}

/// `value` with as many decimals as its neighbours, `step` apart, need: "1.0" beside "1.1".
std::string number_beside(double value, double step) {
    const int decimals = -static_cast<int>(std::floor(std::log10(step) + kHair));
    if (decimals <= 0 || decimals > 5) return number(value);
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals,
                  std::abs(value) < step / 2 ? 0 : value);
    return text.data();
}

/// The smallest of 1, 2, 5, 10 ... times a power of ten that cuts `length` into few steps.
double round_step(double length) {
    const double power = std::pow(10, std::floor(std::log10(length / kMostSteps)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (length / (factor * power) <= kMostSteps * (1 + kHair)) return factor * power;
    }
    return 10 * power;
}

AxisRange linear_range(double low, double high) {
    if (!(high > low)) {
        const double room = low == 0 ? 1 : 0.1 * std::abs(low);
        low -= room, high += room;
    }
    const double step = round_step(high - low);
    return {step * std::floor(low / step + kHair), step * std::ceil(high / step - kHair), false};
}

AxisRange decades(double low, double high) {
    const double first = std::floor(std::log10(low) + kHair);
    const double last = std::ceil(std::log10(high) - kHair);
    return {std::pow(10, first), std::pow(10, std::max(last, first + 1)), true};
}

std::vector<Tick> linear_ticks(const AxisRange& range) {
    std::vector<Tick> ticks;
    const double step = round_step(range.high - range.low);
    const double first = std::ceil(range.low / step - kHair);
    for (double i = first; i * step <= range.high + kHair * step; ++i) {
        ticks.push_back({i * step, number_beside(i * step, step)});
    }
    return ticks;
}

std::vector<Tick> logarithmic_ticks(const AxisRange& range) {
    std::vector<Tick> ticks;
    const double decades = std::log10(range.high) - std::log10(range.low);
    const bool are_few = decades < kFewDecades;
    const int last_digit = decades > kMostSteps ? 1 : 9;
    const double stride = std::max(1.0, std::ceil(decades / kMostSteps));
    const double first = std::floor(std::log10(range.low) + kHair);
    for (double power = first; std::pow(10, power) <= range.high * (1 + kHair); power += stride) {
        for (int digit = 1; digit <= last_digit; ++digit) {
            const double value = digit * std::pow(10, power);
            if (value < range.low * (1 - kHair) || value > range.high * (1 + kHair)) continue;
            const bool has_text = digit == 1 || (are_few && (digit == 2 || digit == 5));
            ticks.push_back({value, has_text ? number(value) : std::string()});
        }
    }
    return ticks;
}

}  // namespace

double AxisRange::position(double value) const {
    if (!is_logarithmic) return (value - low) / (high - low);
    if (!(value > 0)) return -1e3;
    return (std::log(value) - std::log(low)) / (std::log(high) - std::log(low));
}

AxisRange range_of(const std::vector<double>& values, bool is_logarithmic) {
    double low = INFINITY, high = -INFINITY;
    for (const double value : values) {
        if (!(std::abs(value) <= kLargest) || (is_logarithmic && !(value >= 1 / kLargest)))
            continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (!(low <= high)) low = high = 1;
    return is_logarithmic ? decades(low, high) : linear_range(low, high);
}

std::vector<Tick> ticks_of(const AxisRange& range) {
    return range.is_logarithmic ? logarithmic_ticks(range) : linear_ticks(range);
}

}  // namespace bouguer::renderer
