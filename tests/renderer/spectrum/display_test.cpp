// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/display.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
    for (const char* name : {"srgb", "display-p3", "rec709-linear"}) {
        const ShownColour white = find_display(name)->show(d65_white() * 0.999);
        for (const double v : white.rgb) EXPECT_NEAR(v, 1, 2e-3);
        EXPECT_FALSE(white.out_of_gamut || white.over_range);
    }
}

TEST(Display, ClipsAndSaysSo) {
    const Display& srgb = *find_display("srgb");
    const ShownColour white = srgb.show(d65_white() * 2);
    for (const double v : white.rgb) EXPECT_DOUBLE_EQ(v, 1);
    EXPECT_TRUE(white.over_range);
    EXPECT_FALSE(white.out_of_gamut);
    // A spectral green is outside every triangle of primaries inside the locus: red is negative.
    const auto [x, y, z] = cie1931(520);
    const ShownColour green = srgb.show({0.1 * x, 0.1 * y, 0.1 * z});
    EXPECT_EQ(green.rgb[0], 0);
    EXPECT_TRUE(green.out_of_gamut);
    EXPECT_FALSE(green.over_range);
    EXPECT_EQ(srgb.show({}).rgb, (std::array{0.0, 0.0, 0.0}));
}

/// Luminance of what a linear display shows.
double luminance(const Display& display, const std::array<double, 3>& rgb) {
    return shown_by(display, rgb).y;
}

// The luminance stays and the colour moves straight towards the white until it can be shown.
TEST(Display, DesaturatesToTheEdgeOfTheGamutAtTheSameLuminance) {
    const Display& linear = *find_display("rec709-linear");
    const auto [x, y, z] = cie1931(520);
    for (const double scale : {0.1, 1.0, 1.4}) {
        const Xyz green{scale * x, scale * y, scale * z};
        const auto rgb = linear.show(green, GamutMapping::Desaturate).rgb;
        EXPECT_NEAR(luminance(linear, rgb), green.y, 1e-9);
        const auto [low, high] = std::minmax_element(rgb.begin(), rgb.end());
        EXPECT_GE(*low, 0);
        EXPECT_LE(*high, 1);
        EXPECT_TRUE(*low < 1e-12 || *high > 1 - 1e-12);
        // Grey, result and colour on one line.
        const auto all = linear.from_xyz * std::array{green.x, green.y, green.z};
        const double share = (rgb[1] - green.y) / (all[1] - green.y);
        EXPECT_NEAR(rgb[0], green.y + share * (all[0] - green.y), 1e-9);
        EXPECT_NEAR(rgb[2], green.y + share * (all[2] - green.y), 1e-9);
    }
}

TEST(Display, DesaturatesWhatIsTooBrightToWhiteAndLeavesTheRest) {
    const Display& linear = *find_display("rec709-linear");
    EXPECT_EQ(linear.show(d65_white() * 2, GamutMapping::Desaturate).rgb,
              (std::array{1.0, 1.0, 1.0}));
    const Xyz dull{0.2, 0.2, 0.2};
    EXPECT_EQ(linear.show(dull, GamutMapping::Desaturate).rgb, linear.show(dull).rgb);
}

// Whatever comes in, numbers in [0, 1] come out.
TEST(Display, SurvivesWhatIsNoNumber) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const double bad : {std::nan(""), kInfinity, -kInfinity, 1e308})
        for (const GamutMapping mapping : {GamutMapping::Clip, GamutMapping::Desaturate})
            for (const Xyz c : {Xyz{bad, 0.5, 0.5}, Xyz{0.5, bad, 0.5}, Xyz{bad, bad, bad}})
                for (const double v : find_display("srgb")->show(c, mapping).rgb)
                    EXPECT_TRUE(v >= 0 && v <= 1) << bad;
}

// SMPTE ST 2113's and S-2014-004's matrices, printed to four digits.
TEST(Display, MatricesAreThoseOfTheStandards) {
    const Matrix3 p3 = inverse(find_display("display-p3")->from_xyz);
    EXPECT_NEAR(p3[0][0], 0.4866, 1e-4);
    EXPECT_NEAR(p3[1][0], 0.2290, 1e-4);
    EXPECT_NEAR(p3[1][1], 0.6917, 1e-4);
    EXPECT_NEAR(p3[2][2], 1.0439, 1e-4);
    const Matrix3 ap1 = inverse(find_display("acescg")->from_xyz);
    EXPECT_NEAR(ap1[0][0], 0.6624541811, 1e-9);
    EXPECT_NEAR(ap1[1][1], 0.6740817658, 1e-9);
    EXPECT_NEAR(ap1[2][2], 1.0103391003, 1e-9);
}

TEST(Display, ChromaticitiesAreThoseOfTheMatrix) {
    for (const Display& display : displays()) {
        const std::array<std::array<double, 3>, 4> unit{
            {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}};
        for (std::size_t i = 0; i < 4; ++i)
            expect_near(chromaticity(shown_by(display, unit[i])), display.chromaticities[i], 1e-9);
    }
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
