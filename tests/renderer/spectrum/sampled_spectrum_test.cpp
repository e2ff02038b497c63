// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/sampled_spectrum.h"

#include <gtest/gtest.h>

#include <limits>

#include "renderer/spectrum/colour.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// "pointer code" of every problem, in order.
std::vector<std::string> problems_of(const Result<SpectrumPtr>& spectrum) {
    if (spectrum) return {"none"};
    EXPECT_EQ(spectrum.error().kind, ErrorKind::InvalidInput);
    std::vector<std::string> list;
    for (const Problem& p : spectrum.error().problems) list.push_back(p.pointer + " " + p.code);
    return list;
}
using Problems = std::vector<std::string>;

TEST(SampledSpectrum, IsLinearBetweenSamplesAndConstantBeyond) {
    const auto s = sampled_spectrum({400, 500, 700}, {0, 1, 0.5});
    ASSERT_TRUE(s);
    EXPECT_EQ((*s)->at(360), 0);
    EXPECT_EQ((*s)->at(400), 0);
    EXPECT_DOUBLE_EQ((*s)->at(425), 0.25);
    EXPECT_EQ((*s)->at(500), 1);
    EXPECT_DOUBLE_EQ((*s)->at(650), 0.625);
    EXPECT_EQ((*s)->at(700), 0.5);
    EXPECT_EQ((*s)->at(830), 0.5);
    EXPECT_FALSE((*s)->is_constant());
}

TEST(SampledSpectrum, OfEqualValuesIsConstant) {
    const auto s = sampled_spectrum({400, 500, 700}, {0.3, 0.3, 0.3});
    ASSERT_TRUE(s);
    EXPECT_TRUE((*s)->is_constant());
}

TEST(SampledSpectrum, RegularSamplesStandAtEqualSteps) {
    const auto s = regular_spectrum(400, 10, {1, 2, 4});
    ASSERT_TRUE(s);
    EXPECT_EQ((*s)->at(410), 2);
    EXPECT_DOUBLE_EQ((*s)->at(415), 3);
}

// A triangle of area 0.2 about 546.1 nm between the nodes of a 5 nm quadrature: they share its
// energy, and its mean wavelength stays.
TEST(SampledSpectrum, FineSamplesAreNotMissedByCoarseNodes) {
    const auto s = sampled_spectrum({545.9, 546.1, 546.3}, {0, 1, 0});
    ASSERT_TRUE(s);
    EXPECT_EQ((*s)->at(545), 0);
    double integral = 0, mean_nm = 0;
    for (double lambda_nm = 540; lambda_nm <= 555; lambda_nm += 5) {
        integral += (*s)->tent_mean(lambda_nm, 5) * 5;
        mean_nm += (*s)->tent_mean(lambda_nm, 5) * 5 * lambda_nm / 0.2;
    }
    EXPECT_NEAR(integral, 0.2, 1e-12);
    EXPECT_NEAR(mean_nm, 546.1, 1e-9);
}

// A straight line's mean under a symmetric tent is its value at the middle.
TEST(SampledSpectrum, TentMeanOfALineIsItsMiddle) {
    const auto s = regular_spectrum(400, 1, {0, 1, 2, 3, 4, 5, 6, 7, 8});
    EXPECT_NEAR((*s)->tent_mean(404, 2.5), 4, 1e-14);
    // Samples a step apart are taken as they stand.
    const auto spike = regular_spectrum(400, 5, {0, 1, 0});
    EXPECT_EQ((*spike)->tent_mean(405, 5), 1);
}

// F11 has lines: samples taken every 10 nm miss them by 18 %.
TEST(SampledSpectrum, LampsWithLinesKeepTheirColourAt10nm) {
    const SpectrumPtr f11 = library_spectrum("F11");
    const Xyz fine = xyz_of(*f11, 1), coarse = xyz_of(*f11, 10);
    EXPECT_NEAR(coarse.x / fine.x, 1, 0.01);
    EXPECT_NEAR(coarse.y / fine.y, 1, 0.01);
    EXPECT_NEAR(coarse.z / fine.z, 1, 0.01);
}

TEST(SampledSpectrum, NamesEveryProblem) {
    EXPECT_EQ(problems_of(sampled_spectrum({500, 400}, {1, 1})),
              Problems{"/wavelengths_nm/1 not-increasing"});
    EXPECT_EQ(problems_of(sampled_spectrum({500, 500}, {1, 1})),
              Problems{"/wavelengths_nm/1 duplicate"});
    EXPECT_EQ(problems_of(sampled_spectrum({500}, {1})), Problems{"/values too-few"});
    EXPECT_EQ(problems_of(sampled_spectrum({}, {})), Problems{"/values too-few"});
    EXPECT_EQ(problems_of(sampled_spectrum({400, 500}, {1, -0.1})),
              Problems{"/values/1 out-of-range"});
    EXPECT_EQ(problems_of(sampled_spectrum({400, kNan}, {kInfinity, 1})),
              (Problems{"/wavelengths_nm/1 not-finite", "/values/0 not-finite"}));
    EXPECT_EQ(problems_of(sampled_spectrum({400, 500}, {1, 1, 1})),
              Problems{"/values length-mismatch"});
    EXPECT_EQ(problems_of(sampled_spectrum({-5, 500}, {1, 1})),
              Problems{"/wavelengths_nm/0 out-of-range"});
}

TEST(SampledSpectrum, NamesTheProblemsOfRegularSamples) {
    EXPECT_EQ(problems_of(regular_spectrum(400, 0, {1, 1})), Problems{"/step_nm out-of-range"});
    EXPECT_EQ(problems_of(regular_spectrum(kNan, -1, {1})),
              (Problems{"/first_nm not-finite", "/step_nm out-of-range", "/values too-few"}));
    // A step lost in rounding would put two samples at one wavelength.
    EXPECT_EQ(problems_of(regular_spectrum(400, 1e-20, {1, 1})), Problems{"/step_nm out-of-range"});
    EXPECT_EQ(problems_of(regular_spectrum(400, 1e308, {1, 1, 1, 1})),
              Problems{"/step_nm out-of-range"});
}

}  // namespace
}  // namespace bouguer::renderer
