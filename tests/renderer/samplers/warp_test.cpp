// SPDX-License-Identifier: Apache-2.0
#include "renderer/samplers/warp.h"

#include <gtest/gtest.h>

#include "renderer/samplers/sobol.h"

namespace bouguer::renderer {
namespace {

constexpr std::uint32_t kPoints = 1 << 14;

template <class F>
double mean(F f) {
    double sum = 0;
    for (std::uint32_t i = 0; i < kPoints; ++i) sum += f(scrambled_sobol(i, 12345));
    return sum / kPoints;
}

// Under density (n + 1)/(2 pi) cos^n the mean of the cosine is (n + 1)/(n + 2).
TEST(SampleCosinePower, HasTheMeanCosineOfItsDensity) {
    for (const double n : {0.0, 1.0, 20.0, 1e6}) {
        EXPECT_NEAR(mean([&](Vec2 u) { return sample_cosine_power(u, n).z; }), (n + 1) / (n + 2),
                    1e-4)
            << n;
        EXPECT_NEAR(length(sample_cosine_power({0.3, 0.7}, n)), 1, 1e-12);
    }
}

// 1/pdf averages to the solid angle where the pdf is positive: 2 pi for the hemisphere.
TEST(CosinePowerPdf, IsTheDensityOfTheSampler) {
    EXPECT_NEAR(
        mean([](Vec2 u) { return 1 / cosine_power_pdf(sample_cosine_power(u, 0.5).z, 0.5); }),
        2 * kPi, 0.05);
    EXPECT_EQ(cosine_power_pdf(-0.1, 2), 0);
}

// Variances along x: box r^2/3, triangle r^2/6; a Gaussian of sigma r/3 cut at r = 3 sigma keeps
// sigma^2 (1 - (9/2) e^{-9/2} / (1 - e^{-9/2})) = 0.94945 sigma^2 (radius^2/2 exponentially
// distributed, cut at 9/2).
TEST(SampleFilter, HasTheVarianceOfTheFilter) {
    const auto variance = [](FilterType type, double radius) {
        return mean([&](Vec2 u) {
            const double x = sample_filter({type, radius}, u).x;
            return x * x;
        });
    };
    EXPECT_NEAR(variance(FilterType::Box, 0.5), 0.25 / 3, 1e-4);
    EXPECT_NEAR(variance(FilterType::Triangle, 1), 1.0 / 6, 1e-4);
    EXPECT_NEAR(variance(FilterType::Gaussian, 1.5), 0.25 * 0.94945, 2e-4);
}

TEST(SampleFilter, StaysWithinTheRadius) {
    for (const FilterType type : {FilterType::Box, FilterType::Triangle, FilterType::Gaussian}) {
        for (const Vec2 u : {Vec2{0, 0}, Vec2{0.9999999999, 0}, Vec2{0.5, 0.9999999999},
                             Vec2{0.9999999999, 0.5}}) {
            const Vec2 p = sample_filter({type, 2}, u);
            EXPECT_LE(std::abs(p.x), 2.000001);
            EXPECT_LE(std::abs(p.y), 2.000001);
        }
    }
}

}  // namespace
}  // namespace bouguer::renderer
