// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/smooth_reflectance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/spectrum/colour.h"
#include "renderer/spectrum/display.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

// The whole cube, its corners (black, white, the pure primaries) included: every colour comes back.
TEST(SmoothReflectance, SrgbColoursComeBack) {
    for (int i = 0; i < 125; ++i) {
        const std::array rgb{i / 25 / 4.0, i / 5 % 5 / 4.0, i % 5 / 4.0};
        double delta_e = -1;
        const auto s = srgb_spectrum(rgb[0], rgb[1], rgb[2], &delta_e);
        ASSERT_TRUE(s);
        EXPECT_GE(delta_e, 0);
        EXPECT_LT(delta_e, 1e-6) << rgb[0] << " " << rgb[1] << " " << rgb[2];
        // Not by the code that fitted it: XYZ under D65 against D65's own, shown by the display.
        const SpectrumPtr d65 = library_spectrum("D65");
        const Xyz colour = xyz_of_reflectance(**s, *d65);
        const Xyz white = xyz_of_reflectance(*constant_spectrum(1), *d65);
        const auto linear = xyz_to_rec709() * std::array{colour.x, colour.y, colour.z};
        const auto of_white = xyz_to_rec709() * std::array{white.x, white.y, white.z};
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(linear[c] / of_white[c], srgb_decode(rgb[c]), 1e-9);
    }
}

TEST(SmoothReflectance, IsAReflectance) {
    for (const auto& [r, g, b] : {std::array{1.0, 0.0, 0.0}, std::array{0.0, 0.0, 1.0},
                                  std::array{1.0, 1.0, 0.0}, std::array{0.02, 0.9, 1.0}}) {
        const auto s = srgb_spectrum(r, g, b);
        ASSERT_TRUE(s);
        for (double lambda_nm = 360; lambda_nm <= 830; ++lambda_nm) {
            EXPECT_GE((*s)->at(lambda_nm), 0);
            EXPECT_LE((*s)->at(lambda_nm), 1);
        }
    }
}

// A grey needs no wavelengths; the plan counts on it.
TEST(SmoothReflectance, GreysAreConstantAndExact) {
    for (const double v : {0.0, 0.5, 1.0}) {
        double delta_e = -1;
        const auto s = srgb_spectrum(v, v, v, &delta_e);
        ASSERT_TRUE(s);
        EXPECT_TRUE((*s)->is_constant());
        EXPECT_EQ((*s)->at(500), srgb_decode(v));
        EXPECT_LT(delta_e, 1e-12);
    }
}

TEST(SmoothReflectance, RefusesWhatIsNoColour) {
    const auto s = srgb_spectrum(-0.1, 0.5, std::nan(""));
    ASSERT_FALSE(s);
    ASSERT_EQ(s.error().problems.size(), 2U);
    EXPECT_EQ(s.error().problems[0].pointer, "/srgb/0");
    EXPECT_EQ(s.error().problems[1].pointer, "/srgb/2");
    EXPECT_EQ(s.error().problems[1].code, "not-finite");
}

// Black and a grey differ in lightness alone, by L* = 116 * 0.18^(1/3) - 16 [CIE 15:2018, 8.2.1]
// over S_L at the mean of both [Sharma et al. 2005, equation 15].
TEST(SmoothReflectance, DeltaEIsCiede2000) {
    const double L = 116 * std::cbrt(0.18) - 16;
    const double from_middle = (L / 2 - 50) * (L / 2 - 50);
    EXPECT_NEAR(delta_e_2000({0, 0, 0}, {0.18, 0.18, 0.18}),
                L / (1 + 0.015 * from_middle / std::sqrt(20 + from_middle)), 1e-9);
}

}  // namespace
}  // namespace bouguer::renderer
