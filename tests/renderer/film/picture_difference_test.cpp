// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/picture_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "renderer/film/image_decoder.h"
#include "renderer/spectrum/colour_difference.h"

namespace bouguer::renderer {
namespace {

/// The white of sRGB at Y = 1.
constexpr Xyz kWhite{0.3127 / 0.3290, 1, (1 - 0.3127 - 0.3290) / 0.3290};

/// The colour that has these coordinates, by the inverse of their definition [CIE 15:2018, 8.2.1];
/// all three ratios are above (6/29)^3 here.
Xyz colour_of(const Lab& lab) {
    const double fy = (lab.L + 16) / 116, fx = fy + lab.a / 500, fz = fy - lab.b / 200;
    return {kWhite.x * fx * fx * fx, kWhite.y * fy * fy * fy, kWhite.z * fz * fz * fz};
}

LoadedPicture picture_of(int width, const std::vector<Xyz>& pixels) {
    Picture picture{width, static_cast<int>(pixels.size()) / width, {}};
    for (const Xyz& c : pixels)
        for (const double v : {c.x, c.y, c.z}) picture.xyz.push_back(static_cast<float>(v));
    return {picture, false};
}

OutputSettings with_exposure(double exposure) {
    OutputSettings output;
    output.exposure = exposure;
    return output;
}

TEST(PictureDifference, OfAPictureAndItselfIsNone) {
    const auto p = picture_of(2, {kWhite, {0.2, 0.1, 0.3}, {}, {9, 2, 1e9}});
    const auto d = compare_pictures(p, p, {});
    ASSERT_TRUE(d);
    EXPECT_EQ(d->delta_e, (std::vector<float>{0, 0, 0, 0}));
    EXPECT_EQ(d->mean, 0);
    EXPECT_EQ(d->percentile_95, 0);
    EXPECT_EQ(d->maximum, 0);
    EXPECT_EQ(d->compared_pixels, 4U);
}

// Rows 1, 7 and 20 of table 1 of [Sharma et al. 2005], through XYZ and back.
TEST(PictureDifference, IsThatOfThePublishedPairs) {
    const auto a = picture_of(
        3, {colour_of({50, 2.6772, -79.7751}), colour_of({50, 0, 0}), colour_of({50, 2.5, 0})});
    const auto b = picture_of(
        3, {colour_of({50, 0, -82.7485}), colour_of({50, -1, 2}), colour_of({58, 24, 15})});
    const auto d = compare_pictures(a, b, with_exposure(1));
    ASSERT_TRUE(d);
    EXPECT_NEAR(d->delta_e[0], 2.0425, 1e-4);
    EXPECT_NEAR(d->delta_e[1], 2.3669, 1e-4);
    EXPECT_NEAR(d->delta_e[2], 19.4535, 1e-4);
    EXPECT_NEAR(d->mean, (2.0425 + 2.3669 + 19.4535) / 3, 1e-4);
    EXPECT_NEAR(d->maximum, 19.4535, 1e-4);
    EXPECT_EQ(d->maximum_x, 2);
    EXPECT_EQ(d->maximum_y, 0);
}

// L* = 100 and 50: 50 / S_L with S_L = 1 + 0.015 x 25^2 / sqrt(20 + 25^2).
constexpr double kHalfLightness = 36.5193;

TEST(PictureDifference, ExposesBothAlike) {
    const double y50 = std::pow(66.0 / 116, 3);
    const auto a = picture_of(1, {kWhite * 8}), b = picture_of(1, {kWhite * (8 * y50)});
    const auto by_itself = compare_pictures(a, b, {});
    EXPECT_NEAR(by_itself->maximum, kHalfLightness, 1e-3) << "by the exposure of the first";
    EXPECT_DOUBLE_EQ(by_itself->exposure, 0.125);
    EXPECT_NEAR(compare_pictures(a, b, with_exposure(0.125))->maximum, kHalfLightness, 1e-3);
    // L* = 116 (8 y50)^(1/3) - 16 = 116 and 216.
    const double s_l = 1 + 0.015 * 116 * 116 / std::sqrt(20 + 116 * 116);
    EXPECT_NEAR(compare_pictures(a, b, with_exposure(1))->maximum, 100 / s_l, 1e-3)
        << "nothing is clipped";
}

TEST(PictureDifference, OfBlackAndBlackIsNone) {
    const auto d =
        compare_pictures(picture_of(2, {{}, kWhite}), picture_of(2, {{}, {}}), with_exposure(1));
    EXPECT_EQ(d->delta_e[0], 0);
    EXPECT_NEAR(d->delta_e[1], 100, 1e-3);  // S_L is 1 in the middle
}

TEST(PictureDifference, LeavesOutWhatIsNoNumberAndCountsIt) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto a = picture_of(4, {kWhite, {nan, 1, 1}, kWhite, {}});
    const auto b = picture_of(4, {kWhite, kWhite, {1, INFINITY, 1}, {}});
    const auto d = compare_pictures(a, b, with_exposure(1));
    EXPECT_EQ(d->compared_pixels, 2U);
    EXPECT_EQ(d->unknown_pixels, 2U);
    EXPECT_TRUE(std::isnan(d->delta_e[1]));
    EXPECT_EQ(d->mean, 0);
    const auto nothing = compare_pictures(picture_of(1, {{nan, 1, 1}}), b, with_exposure(1));
    ASSERT_FALSE(nothing);
    EXPECT_EQ(nothing.error().code, "different-sizes");
    const auto unknown = picture_of(1, {{nan, 1, 1}});
    EXPECT_TRUE(std::isnan(compare_pictures(unknown, unknown, {})->mean));
}

// Of 40 pixels 95 % are 38: with two that differ the percentile is 0, with three it is not.
TEST(PictureDifference, TakesThe95thPercentile) {
    const std::vector<Xyz> white(40, kWhite);
    for (const std::size_t different : {2U, 3U}) {
        std::vector<Xyz> other = white;
        for (std::size_t i = 0; i < different; ++i) other[3 * i + 1] = {};
        const auto d =
            compare_pictures(picture_of(8, white), picture_of(8, other), with_exposure(1));
        EXPECT_NEAR(d->percentile_95, different == 2 ? 0 : 100, 1e-3);
        EXPECT_NEAR(d->mean, 2.5 * static_cast<double>(different), 1e-3);
        EXPECT_EQ(d->maximum_x, 1) << "the first of equals";
    }
}

// A white and a grey lit by illuminant A: adapted to it they differ as under the display's white.
TEST(PictureDifference, AdaptsToTheWhite) {
    const Chromaticity a{0.44758, 0.40745};
    const Xyz light{a.x / a.y, 1, (1 - a.x - a.y) / a.y};
    const auto white = picture_of(1, {light});
    const auto grey = picture_of(1, {light * std::pow(66.0 / 116, 3)});
    OutputSettings output = with_exposure(1);
    output.white = a;
    for (const Adaptation method : {Adaptation::Bradford, Adaptation::Cat16}) {
        output.adaptation = method;
        EXPECT_NEAR(compare_pictures(white, grey, output)->maximum, kHalfLightness, 1e-3);
    }
    output.adaptation = Adaptation::None;
    EXPECT_GT(std::abs(compare_pictures(white, grey, output)->maximum - kHalfLightness), 0.5);
    output.adaptation = Adaptation::Bradford;
    output.white.reset();
    EXPECT_FALSE(compare_pictures(white, grey, output));
}

// The PNG of a film shows it to half a step of 8 bits, whatever its exposure was.
TEST(PictureDifference, TakesWhatIsShownAsItIs) {
    Picture film{16, 1, {}};
    for (int i = 0; i < 16; ++i)
        for (const double v : {kWhite.x, kWhite.y, kWhite.z})
            film.xyz.push_back(static_cast<float>(v * (i + 1) * 5));
    const LoadedPicture linear{film, false};
    const auto shown = load_picture(encode_png(film, {}).value());
    ASSERT_TRUE(shown);
    for (const auto& d :
         {compare_pictures(linear, *shown, {}), compare_pictures(*shown, linear, {})}) {
        ASSERT_TRUE(d);
        EXPECT_LT(d->maximum, 0.3);
        EXPECT_GT(d->maximum, 0);
        EXPECT_NEAR(d->exposure, 1.0 / 80, 1e-6);
    }
}

TEST(DifferenceMap, GoesFromDarkOverGreenToYellow) {
    PictureDifference d;
    d.width = 5;
    d.height = 1;
    d.delta_e = {0, 5, 10, 300, std::numeric_limits<float>::quiet_NaN()};
    const auto image = decode_image(encode_difference_map(d).value());
    ASSERT_TRUE(image);
    EXPECT_EQ(image->width, 200) << "room for the scale";
    EXPECT_GT(image->height, 20);
    const auto bytes = std::get<std::vector<std::uint8_t>>(image->samples);
    const std::vector<std::uint8_t> expected{0x44, 0x01, 0x54, 0x21, 0x91, 0x8c, 0xfd, 0xe7,
                                             0x25, 0xfd, 0xe7, 0x25, 128,  128,  128,  255};
    EXPECT_EQ(std::vector<std::uint8_t>(bytes.begin(), bytes.begin() + 16), expected);
}

}  // namespace
}  // namespace bouguer::renderer
