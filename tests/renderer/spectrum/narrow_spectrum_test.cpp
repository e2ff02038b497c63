// SPDX-License-Identifier: Apache-2.0
// Gaussians and lines, and that no quadrature misses them.
#include <gtest/gtest.h>

#include <cmath>

#include "renderer/core/vec3.h"
#include "renderer/spectrum/colour.h"
#include "renderer/spectrum/spectra.h"
#include "renderer/spectrum/spectral_basis.h"

namespace bouguer::renderer {
namespace {

/// Integral and mean wavelength of what the nodes of a quadrature see.
struct Moments {
    double integral = 0, mean_nm = 0;
};
Moments seen_by_nodes(const Spectrum& s, double step_nm) {
    Moments m;
    for (double lambda_nm = kLambdaMin_nm; lambda_nm <= kLambdaMax_nm; lambda_nm += step_nm) {
        const double amount = s.tent_mean(lambda_nm, step_nm) * step_nm;
        m.integral += amount;
        m.mean_nm += amount * lambda_nm;
    }
    m.mean_nm /= m.integral;
    return m;
}

TEST(Gaussian, HasItsWidthAndPeak) {
    const auto s = gaussian_spectrum(550, 20, 3);
    ASSERT_TRUE(s);
    EXPECT_EQ((*s)->at(550), 3);
    EXPECT_NEAR((*s)->at(540), 1.5, 1e-12);
    EXPECT_NEAR((*s)->at(560), 1.5, 1e-12);
}

// The integral of a gaussian is peak sigma sqrt(2 pi), for any quadrature that does not miss it.
TEST(Gaussian, KeepsItsEnergyAndPlaceHoweverNarrow) {
    for (const double fwhm_nm : {1e-3, 0.1, 1.0, 5.0, 11.0, 12.0, 30.0}) {
        const auto s = gaussian_spectrum(546.1, fwhm_nm, 2);
        ASSERT_TRUE(s);
        const double expected = 2 * fwhm_nm / std::sqrt(8 * std::log(2.0)) * std::sqrt(2 * kPi);
        for (const double step_nm : {1.0, 5.0}) {
            const Moments m = seen_by_nodes(**s, step_nm);
            EXPECT_NEAR(m.integral / expected, 1, 1e-7) << fwhm_nm << " at " << step_nm;
            EXPECT_NEAR(m.mean_nm, 546.1, 1e-6) << fwhm_nm << " at " << step_nm;
        }
    }
}

// The nodes around a line share it as linear interpolation does, so its colour is that of the
// colour-matching functions between their 1 nm values, exactly.
TEST(Line, HasTheColourOfTheObserverThere) {
    for (const double width_nm : {1e-6, 0.1}) {
        const auto s = line_spectrum(546.5, width_nm, 7);
        ASSERT_TRUE(s);
        const Xyz found = xyz_of(**s, 1);
        const auto [x, y, z] = cie1931(546.5);
        EXPECT_NEAR(found.x, 7 * x / kYIntegral_nm, 1e-9);
        EXPECT_NEAR(found.y, 7 * y / kYIntegral_nm, 1e-9);
        EXPECT_NEAR(found.z, 7 * z / kYIntegral_nm, 1e-9);
        const Xyz coarse = xyz_of(**s, 5);
        EXPECT_NEAR(coarse.y / found.y, 1, 2e-3);
    }
}

TEST(Line, KeepsItsEnergyAndPlace) {
    for (const double width_nm : {1e-6, 0.1, 3.0, 20.0}) {
        const auto s = line_spectrum(588.3, width_nm, 4);
        for (const double step_nm : {1.0, 5.0, 10.0}) {
            const Moments m = seen_by_nodes(**s, step_nm);
            EXPECT_NEAR(m.integral, 4, 1e-6);
            EXPECT_NEAR(m.mean_nm, 588.3, 1e-5);
        }
    }
    EXPECT_DOUBLE_EQ((*line_spectrum(500, 0.5, 4))->at(500.2), 8);
    EXPECT_EQ((*line_spectrum(500, 0.5, 4))->at(500.3), 0);
}

// Light outside the range is no light.
TEST(Line, OutsideTheRangeIsBlack) {
    EXPECT_EQ(xyz_of(**line_spectrum(1064, 0.1, 1), 5), Xyz{});
    EXPECT_EQ(xyz_of(**gaussian_spectrum(1064, 1, 1), 5), Xyz{});
}

// A path carries what xyz_of() sums, through factors and multiples too.
TEST(Line, ReachesTheBasis) {
    const SpectralBasis basis = SpectralBasis::wavelengths(5);
    const SpectrumPtr lamp = scaled_spectrum(
        product_spectrum(*line_spectrum(546.1, 0.1, 1), library_spectrum("IVG530")), 2);
    const Xyz found = basis.to_xyz(basis.emission(*lamp).data());
    EXPECT_NEAR(found.y, xyz_of(*lamp, 5).y, 1e-8);
    EXPECT_NEAR(found.y,
                2 * library_spectrum("IVG530")->at(546.1) * cie1931(546.1)[1] / kYIntegral_nm,
                1e-4);
}

TEST(NarrowSpectra, RefuseWhatHasNoWidth) {
    EXPECT_EQ(gaussian_spectrum(550, 0, 1).error().problems.at(0).pointer, "/fwhm_nm");
    EXPECT_EQ(gaussian_spectrum(std::nan(""), -1, -1).error().problems.size(), 3U);
    EXPECT_EQ(line_spectrum(550, -0.1, 1).error().problems.at(0).pointer, "/width_nm");
    EXPECT_EQ(line_spectrum(0, 1, HUGE_VAL).error().problems.at(1).code, "not-finite");
}

// The mean of a product is not the product of the means: a line of 1 nm and integral 2 inside a
// band of 3 nm and height 1 loses nothing, whatever the step; beside the band nothing is left.
TEST(ProductSpectrum, HasTheMeanOfTheProduct) {
    const auto line = *line_spectrum(550.3, 1, 2);
    const auto sum_at = [](const SpectrumPtr& s, double step) {
        double sum = 0;
        for (double nm = 400; nm < 700; nm += step) sum += step * s->tent_mean(nm, step);
        return sum;
    };
    for (const double step : {1.0, 5.0, 80.0}) {
        const auto through = product_spectrum(line, *line_spectrum(550.5, 3, 3));
        EXPECT_NEAR(sum_at(through, step), 2, 1e-9) << step;
        const auto half = product_spectrum(*line_spectrum(550.8, 1, 1), line);
        EXPECT_NEAR(sum_at(half, step), 1, 1e-9) << "half of the line is in the band, " << step;
        const auto beside = product_spectrum(line, *line_spectrum(552.5, 3, 3));
        EXPECT_NEAR(sum_at(beside, step), 0, 1e-12) << step;
    }
}

// Two bells of 0.02 nm about one wavelength: the integral of their product is
// peak_a peak_b sigma sqrt(pi). A needle of a table of 1e-3 nm in a bell of 10 nm keeps its area.
TEST(ProductSpectrum, OfNeedlesIsExact) {
    const double fwhm = 0.02, sigma = fwhm / std::sqrt(8 * std::log(2.0));
    const auto bell = *gaussian_spectrum(589.3, fwhm, 3);
    const auto both = product_spectrum(bell, *gaussian_spectrum(589.3, fwhm, 5));
    double sum = 0;
    for (double nm = 400; nm < 800; nm += 5) sum += 5 * both->tent_mean(nm, 5);
    EXPECT_NEAR(sum, 15 * sigma * std::sqrt(kPi), 1e-6 * sum);
    const auto needle = *sampled_spectrum({500, 599.9995, 600, 600.0005, 700}, {0, 0, 1e3, 0, 0});
    const auto seen = product_spectrum(needle, *gaussian_spectrum(600, 10, 0.5));
    sum = 0;
    for (double nm = 400; nm < 800; nm += 5) sum += 5 * seen->tent_mean(nm, 5);
    EXPECT_NEAR(sum, 0.5 * 1e3 * 0.0005, 1e-6);
}

double integral_by(const SpectrumPtr& s, double step_nm) {
    double sum = 0;
    for (double nm = 360; nm <= 830; nm += step_nm) sum += step_nm * s->tent_mean(nm, step_nm);
    return sum;
}

// The product of gaussians is a gaussian: 64 of one width about one wavelength have an eighth of
// it, and exp(-(a - b)^2 / (2 (s^2 + t^2))) is left of two apart.
TEST(ProductSpectrum, OfManyBellsIsOneBell) {
    const double fwhm = 10, sigma = fwhm / std::sqrt(8 * std::log(2.0));
    const SpectrumPtr bell = *gaussian_spectrum(550.3, fwhm, 1);
    SpectrumPtr all = bell;
    for (int i = 1; i < 64; ++i) all = product_spectrum(all, bell);
    const double expected = sigma / 8 * std::sqrt(2 * kPi);
    for (const double step : {1.0, 5.0, 10.0})
        EXPECT_NEAR(integral_by(all, step), expected, 1e-8 * expected) << step;
    const SpectrumPtr two =
        product_spectrum(scaled_spectrum(bell, 2), *gaussian_spectrum(556, 4, 3));
    for (const double nm : {540.0, 552.0, 555.5})
        EXPECT_NEAR(two->at(nm), 2 * bell->at(nm) * (*gaussian_spectrum(556, 4, 3))->at(nm), 1e-12);
    // Far apart nothing is left, and large peaks do not make it something else.
    const SpectrumPtr apart =
        product_spectrum(*gaussian_spectrum(400, 0.1, 1e300), *gaussian_spectrum(700, 0.1, 1e300));
    EXPECT_EQ(integral_by(apart, 5), 0);
}

// A band of 8 nm cuts a bell that nodes of 1 nm would see by themselves.
TEST(ProductSpectrum, TakesMeansEverywhereOrNowhere) {
    const double fwhm = 5, sigma = fwhm / std::sqrt(8 * std::log(2.0));
    const SpectrumPtr cut =
        product_spectrum(*line_spectrum(550.3, 8, 8), *gaussian_spectrum(552, fwhm, 1));
    const auto below = [&](double nm) { return std::erf((nm - 552) / (sigma * std::sqrt(2.0))); };
    const double expected = sigma * std::sqrt(kPi / 2) * (below(554.3) - below(546.3));
    for (const double step : {1.0, 5.0, 10.0})
        EXPECT_NEAR(integral_by(cut, step), expected, 1e-8 * expected) << step;
}

// 1 - 0.9 x / 49 to the power of 64, on both sides of 551 nm: 2 x 49 / (0.9 x 65), but for 1e-65.
TEST(ProductSpectrum, OfManyIsNarrowerThanEach) {
    const SpectrumPtr tent = *sampled_spectrum({502, 551, 600}, {0.1, 1, 0.1});
    SpectrumPtr power = tent;
    for (int i = 1; i < 64; ++i) power = product_spectrum(power, tent);
    const double expected = 2 * 49 / (0.9 * 65);
    for (const double step : {1.0, 5.0, 10.0})
        EXPECT_NEAR(integral_by(power, step), expected, 1e-7 * expected) << step;
}

// A triple: a line of 1.7 nm, half a table's ramp and a constant factor. The mean of the ramp
// (nm - 500) / 100 over the line is 0.515.
TEST(ProductSpectrum, OfLineRampAndScale) {
    const SpectrumPtr ramp = *sampled_spectrum({500, 600}, {0, 1});
    const SpectrumPtr three =
        product_spectrum(product_spectrum(scaled_spectrum(ramp, 3), *line_spectrum(551.5, 1.7, 2)),
                         constant_spectrum(0.5));
    for (const double step : {1.0, 5.0, 80.0})
        EXPECT_NEAR(integral_by(three, step), 3 * 2 * 0.5 * 0.515, 1e-9) << step;
}

}  // namespace
}  // namespace bouguer::renderer
