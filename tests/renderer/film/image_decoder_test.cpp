// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/image_decoder.h"

#include <gtest/gtest.h>

#include "renderer/render.h"
#include "tests/support/jpeg_files.h"
#include "tests/support/png_writer.h"

namespace bouguer::renderer {
namespace {

using tests::png_of;

std::string code_of(const Result<DecodedImage>& image) { return image ? "" : image.error().code; }

TEST(DecodeImage, KeepsEightBits) {
    const auto image = decode_image(png_of(2, 1, 3, 8, {0, 128, 255, 1, 2, 3}));
    ASSERT_TRUE(image);
    EXPECT_EQ(image->format, ImageFormat::Png);
    EXPECT_EQ(image->width, 2);
    EXPECT_EQ(image->height, 1);
    EXPECT_EQ(std::get<0>(image->samples), (std::vector<std::uint8_t>{0, 128, 255, 1, 2, 3}));
    EXPECT_EQ(image->values()[2], 1.0F);
}

TEST(DecodeImage, KeepsSixteenBits) {
    const auto image = decode_image(png_of(2, 1, 1, 16, {1, 65535}));
    ASSERT_TRUE(image);
    EXPECT_EQ(std::get<1>(image->samples), (std::vector<std::uint16_t>{1, 65535}));
    EXPECT_EQ(image->values(), (std::vector{1 / 65535.0F, 1.0F}));
}

// Multiplied by its alpha the grey would be 100.
TEST(DecodeImage, LeavesAlphaApart) {
    const auto image = decode_image(png_of(1, 1, 2, 8, {200, 128}));
    ASSERT_TRUE(image);
    EXPECT_EQ(image->channels, 2);
    EXPECT_EQ(std::get<0>(image->samples), (std::vector<std::uint8_t>{200, 128}));
}

TEST(DecodeImage, ReadsJpeg) {
    const auto image = decode_image(tests::rgb_jpeg());
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_EQ(image->format, ImageFormat::Jpeg);
    EXPECT_EQ(image->width, 16);
    EXPECT_EQ(image->height, 8);
    const auto& bytes = std::get<0>(image->samples);
    const std::array expected{200, 100, 50, 20, 30, 220};
    for (std::size_t k = 0; k < 6; ++k) {
        const std::size_t column = k < 3 ? 2 : 12;
        EXPECT_NEAR(bytes[(4 * 16 + column) * 3 + k % 3], expected[k], 1) << k;
    }
}

TEST(DecodeImage, RefusesInks) {
    EXPECT_EQ(code_of(decode_image(tests::cmyk_jpeg())), "bad-image");
}

TEST(DecodeImage, RefusesWhatIsNoImage) {
    for (const char* text : {"", "GIF89a", "ply\nformat ascii 1.0\n", "\x89PNG"})
        EXPECT_EQ(code_of(decode_image(text)), "bad-image") << text;
}

TEST(DecodeImage, RefusesDamagedFiles) {
    const Picture p{64, 48, std::vector<float>(64UL * 48 * 3, 0.5F)};
    for (const std::string& whole : {encode_png(p, {}).value(), encode_exr(p, {}).value(),
                                     png_of(64, 48, 1, 8, std::vector<std::uint16_t>(64UL * 48))}) {
        EXPECT_TRUE(decode_image(whole));
        EXPECT_EQ(code_of(decode_image(whole, /*max_pixels=*/64 * 48 - 1)), "over-limit");
        for (const std::size_t size : {std::size_t{0}, std::size_t{3}, std::size_t{20}})
            EXPECT_FALSE(decode_image(whole.substr(0, size))) << size;
    }
}

// 65535 x 65535 pixels of 8 bytes in a file of a hundred bytes: refused by its header.
TEST(DecodeImage, RefusesBombsBeforeItTakesMemory) {
    const auto image = decode_image(png_of(65535, 65535, 4, 16, {0}));
    EXPECT_EQ(code_of(image), "over-limit");
    EXPECT_NE(image.error().message.find("65535 x 65535"), std::string::npos);
}

}  // namespace
}  // namespace bouguer::renderer
