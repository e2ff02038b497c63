// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/image_file.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "renderer/film/image_decoder.h"
#include "renderer/spectrum/colour.h"
#include "renderer/spectrum/display.h"

namespace bouguer::renderer {
namespace {

Picture picture_of(int width, int height, const std::vector<Xyz>& pixels) {
    Picture picture{width, height, {}};
    for (const Xyz& c : pixels)
        for (const double v : {c.x, c.y, c.z}) picture.xyz.push_back(static_cast<float>(v));
    return picture;
}

Xyz from_linear(double r, double g, double b) {
    const auto [x, y, z] = rec709_to_xyz() * std::array{r, g, b};
    return {x, y, z};
}

OutputSettings with_exposure(double exposure) {
    OutputSettings output;
    output.exposure = exposure;
    return output;
}

/// The 8-bit values of a PNG.
std::vector<int> bytes_of(const Result<std::string>& png) {
    const auto image = decode_image(png.value());
    std::vector<int> bytes;
    for (const float v : image.value().values())
        bytes.push_back(static_cast<int>(std::lround(v * 255)));
    return bytes;
}

// Linear 0.5 encodes to 0.735357 x 255 = 187.5 -> 188; 0.18 to 0.461356 x 255 = 117.6 -> 118.
TEST(Png, ShowsKnownColours) {
    const Picture p = picture_of(2, 2,
                                 {from_linear(1, 1, 1), from_linear(1, 0, 0),
                                  from_linear(0.5, 0.18, 0), from_linear(0, 0, 0)});
    ImageInfo info;
    EXPECT_EQ(bytes_of(encode_png(p, with_exposure(1), &info)),
              (std::vector{255, 255, 255, 255, 0, 0, 188, 118, 0, 0, 0, 0}));
    EXPECT_EQ(info.exposure, 1);
    EXPECT_EQ(info.clipped_pixels, 0U);
}

TEST(Png, CountsWhatTheDisplayCannotShow) {
    const Picture p = picture_of(
        3, 1,
        {from_linear(0.6, 0.6, 0.6), from_linear(-0.1, 0.2, 0.2), from_linear(0.5, 0.5, 0.5)});
    ImageInfo info;
    ASSERT_TRUE(encode_png(p, with_exposure(2), &info));
    EXPECT_EQ(info.clipped_pixels, 2U);
    EXPECT_EQ(info.over_range_pixels, 1U);
    EXPECT_EQ(info.out_of_gamut_pixels, 1U);
}

// Under A everything is yellow; adapted to the display's white, a grey is grey.
TEST(Png, AdaptsTheLightsWhiteToTheDisplays) {
    const Chromaticity a{0.44758, 0.40745};
    const Picture p =
        picture_of(1, 1, {Xyz{a.x / a.y, 1, (1 - a.x - a.y) / a.y} * srgb_decode(0.6)});
    OutputSettings output = with_exposure(1);
    EXPECT_GT(bytes_of(encode_png(p, output))[0], bytes_of(encode_png(p, output))[2] + 60);
    output.adaptation = Adaptation::Cat16;
    EXPECT_FALSE(encode_png(p, output));  // from which white?
    output.white = a;
    EXPECT_EQ(bytes_of(encode_png(p, output)), (std::vector{153, 153, 153}));
    output.display = "lee-9300k";
    for (const int v : bytes_of(encode_png(p, output))) EXPECT_NEAR(v, 153, 1);
}

TEST(Png, MapsColoursAsAsked) {
    const Picture p = picture_of(1, 1, {from_linear(-0.1, 0.4, 0.1)});
    OutputSettings output = with_exposure(1);
    EXPECT_EQ(bytes_of(encode_png(p, output)),
              (std::vector{0, int(std::lround(255 * srgb_encode(0.4))),
                           int(std::lround(255 * srgb_encode(0.1)))}));
    output.gamut = GamutMapping::Desaturate;
    EXPECT_GT(bytes_of(encode_png(p, output))[2], int(std::lround(255 * srgb_encode(0.1))));
}

// Equation 5 shows a D65 white of half its range as (0.64, 0.475, 0.40).
TEST(Png, GoesThroughTheChosenDisplay) {
    OutputSettings output = with_exposure(0.5);
    output.display = "lee-9300k";
    const auto bytes = bytes_of(encode_png(picture_of(1, 1, {from_linear(1, 1, 1)}), output));
    EXPECT_NEAR(bytes[0], 255 * 0.822, 1.5);
    EXPECT_NEAR(bytes[1], 255 * 0.718, 1.5);
    EXPECT_NEAR(bytes[2], 255 * 0.668, 1.5);
}

// The chunk is a claim about colour: sRGB makes it; another display brings its profile.
TEST(Png, SaysWhatItsNumbersMean) {
    const Picture p = picture_of(1, 1, {from_linear(1, 1, 1)});
    OutputSettings output = with_exposure(1);
    const std::string srgb = *encode_png(p, output);
    EXPECT_NE(srgb.find("sRGB"), std::string::npos);
    EXPECT_EQ(srgb.find("iCCP"), std::string::npos);
    for (const char* name : {"lee-9300k", "display-p3"}) {
        output.display = name;
        const std::string other = *encode_png(p, output);
        EXPECT_NE(other.find("iCCP"), std::string::npos);
        for (const char* chunk : {"sRGB", "gAMA", "cHRM"})
            EXPECT_EQ(other.find(chunk), std::string::npos) << chunk;
    }
}

// 200 pixels of Y = 1 ... 200: 99 % of them do not exceed 198.
TEST(AutomaticExposure, TakesThe99thPercentileToOne) {
    Picture p{20, 10, {}};
    for (int i = 200; i >= 1; --i)
        for (int c = 0; c < 3; ++c) p.xyz.push_back(static_cast<float>(i));
    EXPECT_DOUBLE_EQ(automatic_exposure(p), 1.0 / 198);
    ImageInfo info;
    ASSERT_TRUE(encode_png(p, {}, &info));
    EXPECT_DOUBLE_EQ(info.exposure, 1.0 / 198);
}

TEST(AutomaticExposure, SurvivesBlackAndNearlyBlackPictures) {
    Picture p{20, 10, std::vector<float>(600)};
    EXPECT_EQ(automatic_exposure(p), 1);
    EXPECT_EQ(bytes_of(encode_png(p, {})), std::vector<int>(600));
    p.xyz[1] = 4;  // one pixel of 200 gives light: below the percentile
    EXPECT_EQ(automatic_exposure(p), 0.25);
    p.xyz[1] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(automatic_exposure(p), 1);
    EXPECT_TRUE(encode_png(p, {}));
}

TEST(AutomaticExposure, OfOnePixelIsItsOwn) {
    EXPECT_EQ(automatic_exposure(picture_of(1, 1, {{0, 2, 0}})), 0.5);
}

TEST(Exr, KeepsLinearRec709) {
    const auto exr = encode_exr(picture_of(2, 1, {from_linear(1e-9, 0.25, 3e7), {}}), {});
    ASSERT_TRUE(exr);
    const auto image = decode_image(*exr);
    ASSERT_TRUE(image);
    EXPECT_EQ(image->width, 2);
    EXPECT_EQ(image->height, 1);
    ASSERT_EQ(image->channels, 3);
    EXPECT_NEAR(image->values()[2] / 3e7, 1, 1e-6);  // half would be infinite
    EXPECT_EQ(image->values()[5], 0);
    EXPECT_EQ(image->colour.chromaticities,
              (std::array<float, 8>{0.64F, 0.33F, 0.30F, 0.60F, 0.15F, 0.06F, 0.3127F, 0.3290F}));
}

TEST(Exr, KeepsXyzToTheBit) {
    const Picture p = picture_of(1, 2, {{0.1, 0.2, 0.3}, {1e-30, -1, 1e30}});
    OutputSettings output;
    output.exr_colour = FileColour::Xyz;
    const auto image = decode_image(encode_exr(p, output).value());
    ASSERT_TRUE(image);
    EXPECT_EQ(image->values(), p.xyz);
    EXPECT_EQ(image->colour.chromaticities,
              (std::array<float, 8>{1, 0, 0, 1, 0, 0, 1.0F / 3, 1.0F / 3}));
}

// A D65 white is R = G = B in P3 and not in ACEScg, whose white is another.
TEST(Exr, IsWrittenInOtherSpacesToo) {
    OutputSettings output;
    output.exr_colour = FileColour::DisplayP3;
    const Picture white = picture_of(1, 1, {from_linear(1, 1, 1)});
    auto image = decode_image(encode_exr(white, output).value());
    for (const float v : image->values()) EXPECT_NEAR(v, 1, 1e-6);
    EXPECT_EQ((*image->colour.chromaticities)[0], 0.68F);
    output.exr_colour = FileColour::AcesCg;
    image = decode_image(encode_exr(white, output).value());
    EXPECT_GT(image->values()[2], image->values()[0] + 0.05);
    EXPECT_EQ((*image->colour.chromaticities)[6], 0.32168F);
}

// Value 1 has Y = 1: a luminance of 683.002 lm/W x 106.8569171 nm = 72983.5 cd/m^2.
TEST(Exr, SaysTheLuminanceOfWhite) {
    const auto image = decode_image(encode_exr(picture_of(1, 1, {{}}), {}).value());
    ASSERT_TRUE(image);
    ASSERT_TRUE(image->white_luminance);
    EXPECT_NEAR(*image->white_luminance, 72983.5, 0.1);
}

// More than a second apart: a time of writing in the file would show.
TEST(ImageFiles, EqualPicturesGiveEqualBytes) {
    Picture p{64, 48, std::vector<float>(64UL * 48 * 3)};
    for (std::size_t i = 0; i < p.xyz.size(); ++i)
        p.xyz[i] = static_cast<float>(i * 7919 % 1009) / 1009;
    const auto png = encode_png(p, {}), exr = encode_exr(p, {});
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    EXPECT_EQ(png.value(), encode_png(p, {}).value());
    EXPECT_EQ(exr.value(), encode_exr(p, {}).value());
}

TEST(ImageFiles, MayBeWrittenOnManyThreads) {
    const Picture p{64, 48, std::vector<float>(64UL * 48 * 3, 0.5F)};
    const std::string expected = encode_exr(p, {}).value() + encode_png(p, {}).value();
    std::vector<std::string> found(4);
    std::vector<std::thread> threads;
    for (std::string& bytes : found)
        threads.emplace_back(
            [&] { bytes = encode_exr(p, {}).value() + encode_png(p, {}).value(); });
    for (std::thread& thread : threads) thread.join();
    for (const std::string& bytes : found) EXPECT_EQ(bytes, expected);
}

TEST(ImageFiles, RefuseWhatIsNoPicture) {
    EXPECT_FALSE(encode_png(Picture{}, {}));
    EXPECT_FALSE(encode_exr(Picture{2, 2, std::vector<float>(3)}, {}));
    OutputSettings output;
    output.display = "cinema";
    const auto png = encode_png(picture_of(1, 1, {{}}), output);
    ASSERT_FALSE(png);
    EXPECT_EQ(png.error().kind, ErrorKind::InvalidInput);
}

}  // namespace
}  // namespace bouguer::renderer
