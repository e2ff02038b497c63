// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "renderer/film/error_estimate.h"
#include "renderer/samplers/pixel_sampler.h"

namespace bouguer::renderer {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Unit unit(int width, std::uint32_t first, std::uint32_t samples) {
    return {0, 0, 0, width, 1, first, samples};
}

TEST(Film, AveragesTheSamplesOfAPixel) {
    Film film({0, 0, 2, 1}, 4);
    UnitResult result(unit(2, 0, 2), 4);
    result.add_sample(0, 0, 0, {1, 2, 3});
    result.add_sample(0, 0, 1, {3, 4, 5});
    result.add_sample(1, 0, 0, {7, 7, 7});
    result.add_sample(1, 0, 1, {7, 7, 7});
    film.merge(result);
    EXPECT_EQ(film.mean_xyz(), (std::vector<float>{2, 3, 4, 7, 7, 7}));
}

// 1e7 samples of 0.1 and one of 1e6: (1e6 + 1e6) / 10000001, to 1e-9.
TEST(Film, KeepsSmallSamplesBesideALargeOne) {
    Film film({0, 0, 1, 1}, 2);
    for (std::uint32_t pass = 0; pass < 1000; ++pass) {
        UnitResult result(unit(1, pass * 10000, 10000), 2);
        for (std::uint32_t s = 0; s < 10000; ++s)
            result.add_sample(0, 0, pass * 10000 + s, {0.1, 0.1, 0.1});
        film.merge(result);
    }
    UnitResult last(unit(1, 10'000'000, 1), 2);
    last.add_sample(0, 0, 10'000'000, {1e6, 1e6, 1e6});
    film.merge(last);
    EXPECT_NEAR(film.pixel(0).mean().y, 2e6 / 10000001.0, 1e-9);
}

TEST(UnitResult, RejectsWhatIsNoRadianceWithItsWeight) {
    UnitResult result(unit(1, 0, 5), 16);
    result.add_sample(0, 0, 0, {1, 1, 1});
    result.add_sample(0, 0, 1, {std::nan(""), 1, 1});
    result.add_sample(0, 0, 2, {1, kInfinity, 1});
    result.add_sample(0, 0, 3, {1, 1, -1e-9});
    result.add_sample(0, 0, 4, {kInfinity, -kInfinity, 0});
    EXPECT_EQ(result.health().samples, 5U);
    EXPECT_EQ(result.health().rejected_nan, 2U);
    EXPECT_EQ(result.health().rejected_infinite, 1U);
    EXPECT_EQ(result.health().rejected_negative, 1U);
    ASSERT_EQ(result.health().rejected.size(), 4U);
    EXPECT_EQ(result.health().rejected[1].sample, 2U);
    EXPECT_EQ(result.health().rejected[1].kind, "infinite");

    Film film({0, 0, 1, 1}, 16);
    film.merge(result);
    EXPECT_EQ(film.pixel(0).mean(), (Xyz{1, 1, 1}))
        << "the pixel is not darkened by what was rejected";
}

TEST(UnitResult, RemembersTheFirstRejectionsOnly) {
    UnitResult result(unit(1, 0, 1000), 16);
    for (std::uint32_t s = 0; s < 1000; ++s) result.add_sample(0, 0, s, {-1, 0, 0});
    EXPECT_EQ(result.health().rejected_negative, 1000U);
    EXPECT_EQ(result.health().rejected.size(), UnitResult::kMaxRejectedKept);
}

/// A film of `pixels` whose samples are `value(u)` with u uniform.
template <class F>
Film synthetic(std::uint64_t seed, int pixels, std::uint32_t samples, F value) {
    Film film({0, 0, pixels, 1}, 16);
    UnitResult result(unit(pixels, 0, samples), 16);
    for (int x = 0; x < pixels; ++x) {
        for (std::uint32_t s = 0; s < samples; ++s) {
            const double v = value(PixelSampler(hash(seed, s), x, 0, 0, 16).get_2d(0).x);
            result.add_sample(x, 0, s, {v, v, v});
        }
    }
    film.merge(result);
    return film;
}

// Uniform samples have variance 1/12; the mean of 32 has standard error sqrt(1/12/32) = 0.0510310.
// With 16 replicates and 1000 pixels the estimate itself spreads by sqrt(1/(2*15*1000)) = 0.6 %;
// tested at five of these.
TEST(EstimateError, IsTheStandardErrorOfUniformSamples) {
    const auto estimate = estimate_error(synthetic(1, 1000, 32, [](double u) { return u; }));
    ASSERT_TRUE(estimate);
    EXPECT_NEAR(estimate->rmse.value / 0.0510310, 1, 0.03);
    EXPECT_NEAR(estimate->relative_rmse.value / (2 * 0.0510310), 1, 0.03);
    EXPECT_FALSE(estimate->few_events);
}

// The interval is meant to hold the true value in 95 of 100 independent films: 200 films, binomial
// standard error 1.5 %, tested at 3 of these.
TEST(EstimateError, IntervalCoversTheTruth) {
    int covered = 0;
    for (std::uint64_t film = 0; film < 200; ++film) {
        const auto estimate = estimate_error(synthetic(film, 200, 16, [](double u) { return u; }));
        const double truth = std::sqrt(1.0 / 12 / 16);
        if (estimate->rmse.low <= truth && truth <= estimate->rmse.high) ++covered;
    }
    EXPECT_GE(covered, 181);
    EXPECT_LE(covered, 199);
}

// Replicates with unequal numbers of samples: 24 samples fill eight replicates twice and eight
// once.
TEST(EstimateError, WeighsReplicatesByTheirSamples) {
    const auto estimate = estimate_error(synthetic(3, 2000, 24, [](double u) { return u; }));
    EXPECT_NEAR(estimate->rmse.value / std::sqrt(1.0 / 12 / 24), 1, 0.03);
}

TEST(EstimateError, IsUnknownFromOneSample) {
    EXPECT_FALSE(estimate_error(synthetic(1, 10, 1, [](double u) { return u; })));
}

TEST(EstimateError, IsZeroWhenNothingVaries) {
    const auto black = estimate_error(synthetic(1, 10, 16, [](double) { return 0.0; }));
    ASSERT_TRUE(black);
    EXPECT_EQ(black->rmse.value, 0);
    EXPECT_EQ(black->relative_rmse.value, 0);
}

// One pixel in 2000 sees an event: all the variance sits there, and the flag says that the interval
// cannot be trusted.
TEST(EstimateError, FlagsRareEvents) {
    const auto estimate =
        estimate_error(synthetic(5, 500, 16, [](double u) { return u < 2e-4 ? 1e4 : 0.1; }));
    ASSERT_TRUE(estimate);
    EXPECT_TRUE(estimate->few_events);
}

}  // namespace
}  // namespace bouguer::renderer
