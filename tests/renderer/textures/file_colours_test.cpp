// SPDX-License-Identifier: Apache-2.0
#include "renderer/textures/file_colours.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/film/image_file.h"
#include "renderer/render.h"
#include "renderer/spectrum/display.h"
#include "renderer/textures/channel_tables.h"
#include "tests/support/png_writer.h"

namespace bouguer::renderer {
namespace {

using tests::png_of;
using tests::with_png_chunk;

Result<TextureImagePtr> read(const std::string& bytes) {
    return read_texture_image(bytes, 1000).and_then(&in_file_colours);
}

/// The light in a file's first pixels; empty when it is refused.
std::vector<float> light_of(const std::string& bytes) {
    const auto image = read(bytes);
    EXPECT_TRUE(image) << image.error().message;
    if (!image) return {};
    EXPECT_EQ((*image)->encoding, ColourEncoding::Linear);
    const auto* floats = std::get_if<std::vector<float>>(&(*image)->samples);
    return floats != nullptr ? *floats : std::vector<float>{};
}

const std::string kP3("\x0c\x0d\0\1", 4);

std::string exr_of(const std::vector<float>& xyz, FileColour colour) {
    OutputSettings output;
    output.exr_colour = colour;
    return encode_exr({static_cast<int>(xyz.size() / 3), 1, xyz}, output).value();
}

TEST(FileColours, LeavesKnownNumbersAlone) {
    const auto image = read_texture_image(png_of(1, 1, 3, 8, {1, 2, 3}), 1000);
    ASSERT_TRUE(image);
    EXPECT_EQ(conversion_bytes(**image), 0U);
    EXPECT_EQ(in_file_colours(*image)->get(), image->get());
}

TEST(FileColours, DecodesByTheFilesCurve) {
    const std::string png =
        with_png_chunk(png_of(2, 1, 1, 8, {0, 128}), "gAMA", tests::big_endian(45455));
    const auto image = read_texture_image(png, 1000);
    EXPECT_EQ(conversion_bytes(**image), 2 * sizeof(float));
    const auto light = light_of(png);
    ASSERT_EQ(light.size(), 2U);
    EXPECT_EQ(light[0], 0);
    EXPECT_NEAR(light[1], std::pow(128 / 255.0, 2.2), 1e-5);
}

// sRGB's red in the bytes of P3: a step more or less of them is allowed to leave Rec.709.
TEST(FileColours, TakesWhatIsWithinRec709) {
    const auto light = light_of(with_png_chunk(png_of(1, 1, 3, 8, {234, 51, 35}), "cICP", kP3));
    ASSERT_EQ(light.size(), 3U);
    EXPECT_NEAR(light[0], 1, 5e-3);
    EXPECT_GE(light[1], 0);
    EXPECT_NEAR(light[1], 0, 5e-3);
    EXPECT_NEAR(light[2], 0, 5e-3);
    EXPECT_LE(light[0], 1);
}

TEST(FileColours, RefusesWhatIsNot) {
    for (const std::uint16_t red : {255, 100, 30}) {
        const std::vector<std::uint16_t> numbers{9, 9, 9, red, 0, 0};
        const auto image = read(with_png_chunk(png_of(2, 1, 3, 8, numbers), "cICP", kP3));
        ASSERT_FALSE(image) << red;
        EXPECT_EQ(image.error().code, "bad-image");
        EXPECT_NE(image.error().message.find("column 1, row 0 is outside Rec.709"),
                  std::string::npos)
            << image.error().message;
    }
}

// A picture that is large enough to be taken by tables says the same, pixel by pixel.
TEST(FileColours, MakesTheSameOfLargePictures) {
    std::vector<std::uint16_t> numbers;
    for (std::uint16_t i = 0; i < 2000; ++i)
        for (const int k : {0, 1, 2})
            numbers.push_back(static_cast<std::uint16_t>(90 + i * (k + 3) % 60));
    const auto of = [&](std::size_t first, int count) {
        const auto from = numbers.begin() + static_cast<std::ptrdiff_t>(3 * first);
        return with_png_chunk(png_of(count, 1, 3, 8, {from, from + 3 * count}), "cICP", kP3);
    };
    const auto read_large = read_texture_image(of(0, 2000), 2000).and_then(&in_file_colours);
    ASSERT_TRUE(read_large) << read_large.error().message;
    const auto& large = std::get<std::vector<float>>((*read_large)->samples);
    for (std::size_t i = 0; i < 2000; i += 100) {
        const auto alone = light_of(of(i, 2));
        ASSERT_EQ(alone.size(), 6U);
        for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(large[3 * i + k], alone[k], 2e-5) << i;
    }
}

TEST(ChannelTables, AreThereWhereChannelsAddUp) {
    const PictureColour p3{{}, listed(find_display("display-p3")->chromaticities), {}};
    const auto to_light = linear_rec709(p3, ColourEncoding::Srgb, false);
    const auto tables = ChannelTables::make(*to_light, 255, false);
    ASSERT_TRUE(tables);
    std::array pixel{200 / 255.0F, 100 / 255.0F, 50 / 255.0F};
    (*to_light)(pixel);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR((*tables)({200, 100, 50})[k], pixel[k], 1e-6);
    const ToRec709 product = [](std::span<float> p) {
        for (std::size_t i = 0; i < p.size(); i += 3) p[i] *= p[i + 1];
    };
    EXPECT_FALSE(ChannelTables::make(product, 255, false));
    const auto greys = ChannelTables::make(product, 255, true);
    ASSERT_TRUE(greys);
    EXPECT_NEAR((*greys)({51, 51, 51})[0], 0.04, 1e-6);
}

// Linear, brighter than 1; a colour within Rec.709 comes back as it was.
TEST(FileColours, ConvertsExrByItsChromaticities) {
    const auto& from_xyz = find_display("rec709-linear")->from_xyz;
    const std::vector<float> xyz{1.2F, 1.3F, 0.9F};
    const auto expected = from_xyz * std::array{1.2, 1.3, 0.9};
    const auto p3 = light_of(exr_of(xyz, FileColour::DisplayP3));  // of the same white
    ASSERT_EQ(p3.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(p3[k], expected[k], 1e-5);
    // XYZ's own white is that of equal energy, and its primaries have no luminance but for Y.
    for (const float v : light_of(exr_of({2, 2, 2}, FileColour::Xyz))) EXPECT_NEAR(v, 2, 1e-5);
    const float white[]{0.32168F / 0.33767F, 1, 0.34065F / 0.33767F};
    const auto aces = light_of(exr_of({white, white + 3}, FileColour::AcesCg));
    ASSERT_EQ(aces.size(), 3U);
    for (const float v : aces) EXPECT_NEAR(v, 1, 1e-5);
}

}  // namespace
}  // namespace bouguer::renderer
