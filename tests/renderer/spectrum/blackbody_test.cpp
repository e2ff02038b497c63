// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "renderer/spectrum/colour.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

// Planck's law at 555 nm with the CODATA 2018 constants, evaluated in high precision.
TEST(Blackbody, FollowsPlancksLawFromRoomTemperatureToStars) {
    struct {
        double temperature_K, radiance;
    } constexpr kExpected[] = {{300, 6.695181e-23},
                               {2856, 2.584769e11},
                               {5000, 1.274031e13},
                               {6504, 4.281319e13},
                               {1e9, 8.724819e19}};
    for (const auto& [temperature_K, radiance] : kExpected)
        EXPECT_NEAR(planck_W_per_m3_sr(555, temperature_K) / radiance, 1, 1e-6) << temperature_K;
    EXPECT_EQ(planck_W_per_m3_sr(555, 1), 0);  // exp(-25923) is no number
}

TEST(Blackbody, SpectrumIsPlancksLawRelativeTo560) {
    for (const double temperature_K : {300.0, 2856.0, 6504.0, 1e6, 1e9}) {
        const auto s = blackbody_spectrum(temperature_K);
        ASSERT_TRUE(s);
        EXPECT_DOUBLE_EQ((*s)->at(560), 1);
        for (const double lambda_nm : {400.0, 555.0, 700.0}) {
            const double expected = planck_W_per_m3_sr(lambda_nm, temperature_K) /
                                    planck_W_per_m3_sr(560, temperature_K);
            EXPECT_NEAR((*s)->at(lambda_nm) / expected, 1, 1e-12);
        }
    }
}

// Rayleigh and Jeans: proportional to lambda^-4 when h c / (lambda k T) is small.
TEST(Blackbody, TheHottestFollowsRayleighAndJeans) {
    const auto s = blackbody_spectrum(1e9);
    ASSERT_TRUE(s);
    EXPECT_NEAR((*s)->at(400) / std::pow(560.0 / 400, 4), 1, 1e-5);
}

// CIE 15:2018: illuminant A is the black body of 2856 K on the temperature scale of 1931, whose
// second radiation constant was 1.435e-2 m K: 2848 K there is 2855.5 K today.
TEST(Blackbody, IlluminantAIsABlackBody) {
    const auto s = blackbody_spectrum(2848 * 1.438776877e-2 / 1.435e-2);
    ASSERT_TRUE(s);
    for (double lambda_nm = 360; lambda_nm <= 830; lambda_nm += 10)
        EXPECT_NEAR(library_spectrum("A")->at(lambda_nm) / (*s)->at(lambda_nm), 1, 1e-8);
}

// Finite also as single precision, which is what a path carries.
TEST(Blackbody, EveryAcceptedTemperatureIsFiniteEverywhere) {
    for (const double temperature_K : {kBlackbodyMin_K, 150.0, 1e3, 1e5, kBlackbodyMax_K}) {
        const auto s = blackbody_spectrum(temperature_K);
        ASSERT_TRUE(s);
        for (const double lambda_nm : {360.0, 560.0, 830.0}) {
            EXPECT_TRUE(std::isfinite(static_cast<float>((*s)->at(lambda_nm))));
            EXPECT_GE((*s)->at(lambda_nm), 0);
        }
    }
}

// From 1 K, whose visible light is below the smallest number, to 1e9 K: a radiance per nm.
TEST(Blackbody, RadianceIsFiniteAtEveryTemperature) {
    EXPECT_EQ((*blackbody_radiance_spectrum(1))->at(555), 0);
    EXPECT_NEAR((*blackbody_radiance_spectrum(300))->at(555) / 6.695181e-32, 1, 1e-6);
    EXPECT_NEAR((*blackbody_radiance_spectrum(1e9))->at(555) / 8.724819e10, 1, 1e-6);
    for (const double temperature_K : {-1.0, 0.0, 1.1e9, HUGE_VAL})
        EXPECT_FALSE(blackbody_radiance_spectrum(temperature_K));
}

TEST(Blackbody, RefusesWhatCannotBeWrittenDown) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    for (const double temperature_K : {kNan, -1.0, 0.0, 1.0, 99.9, 1.1e9, HUGE_VAL}) {
        const auto s = blackbody_spectrum(temperature_K);
        ASSERT_FALSE(s) << temperature_K;
        EXPECT_EQ(s.error().kind, ErrorKind::InvalidInput);
        EXPECT_EQ(s.error().problems.at(0).pointer, "/blackbody_K");
    }
    EXPECT_NE(blackbody_spectrum(50).error().message.find("560 nm"), std::string::npos);
}

}  // namespace
}  // namespace bouguer::renderer
