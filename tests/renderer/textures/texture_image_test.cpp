// SPDX-License-Identifier: Apache-2.0
#include "renderer/textures/texture_image.h"

#include <gtest/gtest.h>

#include <limits>

#include "renderer/render.h"
#include "tests/support/png_writer.h"

namespace bouguer::renderer {
namespace {

using tests::png_of;

Result<TextureImagePtr> read(const std::string& bytes) { return read_texture_image(bytes, 1000); }

/// A linear EXR of grey pixels in a row.
std::string grey_exr(const std::vector<float>& greys, FileColour colour = FileColour::Rec709) {
    Picture picture{static_cast<int>(greys.size()), 1, {}};
    for (const float grey : greys)
        for (int k = 0; k < 3; ++k) picture.xyz.push_back(grey);
    OutputSettings output;
    output.exr_colour = colour;
    return encode_exr(picture, output).value();
}

void expect_refusal(const std::string& bytes, const std::string& code, const std::string& words) {
    const auto image = read(bytes);
    ASSERT_FALSE(image) << words;
    EXPECT_EQ(image.error().code, code);
    EXPECT_NE(image.error().message.find(words), std::string::npos) << image.error().message;
}

TEST(TextureImage, KeepsColours) {
    const auto image = read(png_of(1, 2, 3, 8, {10, 20, 30, 40, 50, 60}));
    ASSERT_TRUE(image);
    EXPECT_EQ((*image)->channels, 3);
    EXPECT_EQ((*image)->memory_bytes(), 6U);
    EXPECT_EQ((*image)->largest, 60.0 / 255);
    EXPECT_EQ((*image)->largest_at.row, 1);
}

TEST(TextureImage, KeepsGreyOnce) {
    const auto image = read(png_of(2, 1, 3, 16, {7, 7, 7, 500, 500, 500}));
    ASSERT_TRUE(image);
    EXPECT_EQ((*image)->channels, 1);
    EXPECT_EQ(std::get<1>((*image)->samples), (std::vector<std::uint16_t>{7, 500}));
    EXPECT_EQ((*image)->memory_bytes(), 4U);
}

TEST(TextureImage, DropsAlphaThatHidesNothing) {
    const auto image = read(png_of(2, 1, 4, 8, {1, 2, 3, 255, 4, 5, 6, 255}));
    ASSERT_TRUE(image);
    EXPECT_EQ(std::get<0>((*image)->samples), (std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6}));
}

TEST(TextureImage, RefusesTransparency) {
    expect_refusal(png_of(2, 1, 4, 8, {1, 2, 3, 255, 4, 5, 6, 254}), "bad-image",
                   "column 1, row 0");
}

TEST(TextureImage, RefusesWhatIsNoLight) {
    expect_refusal(grey_exr({0, -0.5F}), "out-of-range", "negative at column 1, row 0");
    expect_refusal(grey_exr({std::numeric_limits<float>::infinity()}), "not-finite", "column 0");
    expect_refusal(grey_exr({1, 1, std::numeric_limits<float>::quiet_NaN()}), "not-finite",
                   "column 2");
}

TEST(TextureImage, KnowsWhatItsNumbersAre) {
    EXPECT_EQ((*read(png_of(1, 1, 1, 8, {9})))->encoding, ColourEncoding::Srgb);
    EXPECT_EQ((*read(grey_exr({0.5F})))->encoding, ColourEncoding::Linear);
    const std::string linear =
        tests::with_png_chunk(png_of(1, 1, 1, 8, {9}), "gAMA", tests::big_endian(100000));
    EXPECT_EQ((*read(linear))->encoding, ColourEncoding::Linear);
    EXPECT_EQ((*read(grey_exr({0.5F}, FileColour::AcesCg)))->encoding, std::nullopt);
}

TEST(TextureImage, RefusesTooManyPixels) {
    EXPECT_EQ(read(png_of(2000, 1, 1, 8, {0})).error().code, "over-limit");
}

}  // namespace
}  // namespace bouguer::renderer
