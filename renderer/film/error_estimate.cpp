// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/error_estimate.h"

#include <array>
#include <cmath>

namespace bouguer::renderer {
namespace {

/// Below this many pixels' worth of variance the interval covers less than it says.
constexpr double kFewEvents = 25;

/// Variance of the pixel's mean, averaged over X, Y, Z; empty when fewer than two replicates have
/// samples.
std::optional<double> variance_of_mean(const Film& film, std::size_t i) {
    const Film::Pixel& pixel = film.pixel(i);
    const Film::Replicate* replicates = film.replicates_of(i);
    const Xyz mean_xyz = pixel.mean();
    const std::array<double, 3> mean{mean_xyz.x, mean_xyz.y, mean_xyz.z};
    double spread = 0;
    int used = 0;
    for (std::uint32_t r = 0; r < film.replicates(); ++r) {
        const double count = replicates[r].count;
        if (count == 0) continue;
        ++used;
        double squares = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double d = replicates[r].sum[c] / count - mean[c];
            squares += d * d;
        }
        spread += count * squares;
    }
    if (used < 2) return std::nullopt;
    return spread / (3 * static_cast<double>(pixel.count) * (used - 1));
}

Estimate scaled(Estimate e, double s) { return {e.value * s, e.low * s, e.high * s}; }

}  // namespace

std::optional<ErrorEstimate> estimate_error(const Film& film) {
    double sum = 0;
    double sum_of_squares = 0;
    double brightness = 0;
    double pixels = 0;
    for (std::size_t i = 0; i < film.num_pixels(); ++i) {
        const auto v = variance_of_mean(film, i);
        if (!v) continue;
        pixels += 1;
        sum += *v;
        sum_of_squares += *v * *v;
        const Xyz mean = film.pixel(i).mean();
        brightness += (mean.x + mean.y + mean.z) / 3;
    }
    if (pixels == 0) return std::nullopt;

    ErrorEstimate estimate;
    if (sum == 0) return estimate;  // every replicate agrees: no noise at all
    const double mean_variance = sum / pixels;
    const double spread = std::max(0.0, sum_of_squares / pixels - mean_variance * mean_variance);
    const double relative_error = std::sqrt(spread / std::max(1.0, pixels - 1)) / mean_variance;
    const double rmse = std::sqrt(mean_variance);
    // d(ln rmse) = d(variance) / (2 variance)
    const double factor = std::exp(1.959963984540054 * relative_error / 2);
    estimate.rmse = {rmse, rmse / factor, rmse * factor};
    estimate.relative_rmse = scaled(estimate.rmse, brightness > 0 ? pixels / brightness : 0);
    estimate.few_events = sum * sum < kFewEvents * sum_of_squares;
    return estimate;
}

}  // namespace bouguer::renderer
