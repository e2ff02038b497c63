// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/display.h"

#include <gtest/gtest.h>

#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

Xyz d65_white() { return xyz_of_reflectance(*constant_spectrum(1), *library_spectrum("D65")); }

Xyz shown_by(const Display& display, const std::array<double, 3>& linear_rgb) {
    const auto [x, y, z] = inverse(display.from_xyz) * linear_rgb;
    return {x, y, z};
}

void expect_near(Chromaticity found, Chromaticity expected, double tolerance) {
    EXPECT_NEAR(found.x, expected.x, tolerance);
    EXPECT_NEAR(found.y, expected.y, tolerance);
}

// The reading of equation 5: what the paper's matrix says of its display.
TEST(Display, TheSeedsMatrixDescribesATelevisionOf9300K) {
    const Display* lee = find_display("lee-9300k");
    ASSERT_TRUE(lee);
    expect_near(chromaticity(shown_by(*lee, {1, 1, 1})), {0.2810, 0.3110}, 5e-5);
    EXPECT_NEAR(shown_by(*lee, {1, 1, 1}).y, 0.9999, 1e-4);
    expect_near(chromaticity(shown_by(*lee, {1, 0, 0})), {0.6410, 0.3270}, 1e-4);
    expect_near(chromaticity(shown_by(*lee, {0, 1, 0})), {0.2720, 0.5910}, 1e-4);
    expect_near(chromaticity(shown_by(*lee, {0, 0, 1})), {0.1410, 0.0520}, 1e-4);
}

TEST(Display, TheSeedsDisplayShowsD65AsAReddishWhite) {
    const Xyz white = d65_white();
    const auto rgb = find_display("lee-9300k")->from_xyz * std::array{white.x, white.y, white.z};
    EXPECT_NEAR(rgb[0], 1.28, 0.005);
    EXPECT_NEAR(rgb[1], 0.95, 0.005);
    EXPECT_NEAR(rgb[2], 0.80, 0.005);
}

// sRGB's white is D65 in four digits of chromaticity.
TEST(Display, SrgbShowsD65AsWhite) {
    bool clipped = true;
    for (const double v : find_display("srgb")->show(d65_white() * 0.999, &clipped))
        EXPECT_NEAR(v, 1, 1e-3);
    EXPECT_FALSE(clipped);
}

TEST(Display, ClipsAndSaysSo) {
    bool clipped = false;
    const auto white = find_display("srgb")->show(d65_white() * 2, &clipped);
    for (const double v : white) EXPECT_DOUBLE_EQ(v, 1);
    EXPECT_TRUE(clipped);
    // A spectral green is outside every triangle of primaries inside the locus: red is negative.
    const auto [x, y, z] = cie1931(520);
    EXPECT_EQ(find_display("srgb")->show({0.1 * x, 0.1 * y, 0.1 * z}, &clipped)[0], 0);
    EXPECT_TRUE(clipped);
    EXPECT_EQ(find_display("srgb")->show({}, &clipped), (std::array{0.0, 0.0, 0.0}));
    EXPECT_FALSE(clipped);
}

// IEC 61966-2-1: 12.92 x below 0.0031308; 0.5 encodes to 0.735357.
TEST(Display, SrgbCurveIsThatOfTheStandard) {
    EXPECT_DOUBLE_EQ(srgb_encode(0.001), 0.01292);
    EXPECT_NEAR(srgb_encode(0.5), 0.735357, 1e-6);
    for (double v = 0; v <= 1; v += 1.0 / 64) EXPECT_NEAR(srgb_decode(srgb_encode(v)), v, 1e-7);
}

TEST(Display, UnknownNamesHaveNone) { EXPECT_EQ(find_display("sRGB"), nullptr); }

}  // namespace
}  // namespace bouguer::renderer
