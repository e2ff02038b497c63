// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/image_decoder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/film/icc_profile.h"
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

/// Every way to write a picture.
std::vector<std::string> whole_files() {
    const Picture p{9, 7, std::vector<float>(9UL * 7 * 3, 0.5F)};
    return {encode_png(p, {}).value(), encode_exr(p, {}).value(),
            png_of(9, 7, 1, 8, std::vector<std::uint16_t>(9UL * 7)), tests::rgb_jpeg(),
            tests::progressive_jpeg()};
}

// As after an upload that breaks off: no length but the whole one gives a picture.
TEST(DecodeImage, RefusesFilesThatBreakOffAnywhere) {
    for (const std::string& whole : whole_files()) {
        const auto image = decode_image(whole);
        ASSERT_TRUE(image) << image.error().message;
        for (std::size_t size = 0; size < whole.size(); ++size)
            EXPECT_EQ(code_of(decode_image(whole.substr(0, size))), "bad-image")
                << size << " of " << whole.size();
    }
}

// What follows the end belongs to nobody: cameras put previews there.
TEST(DecodeImage, ReadsNothingBehindTheEnd) {
    for (const std::string& whole : whole_files()) {
        const auto more = decode_image(whole + "more");
        ASSERT_TRUE(more) << more.error().message;
        EXPECT_EQ(more->values(), decode_image(whole)->values());
    }
}

// Each chunk has a check sum, and its name is read by it; IEND is the end.
TEST(DecodeImage, RefusesPngWithAnyByteChanged) {
    const std::string whole = tests::with_png_chunk(
        png_of(3, 2, 3, 8, std::vector<std::uint16_t>(18, 77)), "gAMA", tests::big_endian(45455));
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
        EXPECT_FALSE(decode_image(damaged)) << i;
    }
}

/// The reason why a file is refused.
std::string reason(const std::string& file) {
    const auto image = decode_image(file);
    return image ? "it is read" : image.error().message;
}

void expect_reason(const std::string& file, const std::string& words) {
    EXPECT_NE(reason(file).find(words), std::string::npos) << reason(file) << "\n" << words;
}

/// `text` with the first `from` in it as `to`.
std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos);
    return text.replace(at, from.size(), to);
}

TEST(DecodeImage, SaysWhereAPngIsDamaged) {
    const std::string whole = png_of(1, 1, 1, 8, {200});
    expect_reason(replaced(whole, "IDAT", "IDAt"), "chunk IDAt at byte 33");
    expect_reason(whole.substr(0, 40), "breaks off");
    expect_reason(whole.substr(0, 50), "chunk IDAT at byte 33");
    const std::string gamma = tests::big_endian(100000);
    const std::string once = tests::with_png_chunk(whole, "gAMA", gamma);
    expect_reason(tests::with_png_chunk(once, "gAMA", gamma), "twice");
    expect_reason(tests::with_png_chunk(whole, "ABCD", ""), "no known kind");
    expect_reason(tests::with_png_chunk(whole, "IEND", ""), "before any pixels");
    // 2 bytes a row are wanted; the chunk's own check sum is right
    expect_reason(tests::with_png_chunk(whole, "IDAT", tests::zlib_of("\1")), "1 bytes of 2");
    std::string sum = tests::zlib_of(std::string("\0\1", 2));
    sum.back() = 'x';
    expect_reason(tests::with_png_chunk(whole, "IDAT", sum), "damaged");
    expect_reason(tests::with_png_chunk(whole, "IDAT", tests::zlib_of("123")), "damaged");
}

// Seven passes over a picture of 3 x 5, in rows of their own [PNG 3rd ed. §8]: pass 1 has 1 x 1
// pixels, 4 has 1 x 2, 5 has 2 x 1, 6 has 1 x 3 and 7 has 3 x 2; 3 has 1 x 1 and 2 none.
TEST(DecodeImage, CountsThePixelsOfInterlacedPng) {
    std::string png = "\x89PNG\r\n\x1a\n";
    png += tests::png_chunk(
        "IHDR", tests::big_endian(3) + tests::big_endian(5) + std::string("\x08\0\0\0\1", 5));
    const auto of = [&](std::size_t bytes) {
        return png + tests::png_chunk("IDAT", tests::zlib_of(std::string(bytes, '\0'))) +
               tests::png_chunk("IEND", "");
    };
    constexpr std::size_t kBytes = 2 + 2 + 2 * 2 + 3 + 3 * 2 + 2 * 4;
    EXPECT_EQ(reason(of(kBytes)), "it is read");
    EXPECT_NE(reason(of(kBytes - 1)), "it is read");
    EXPECT_NE(reason(of(kBytes + 1)), "it is read");
}

TEST(DecodeImage, SaysWhereAJpegIsDamaged) {
    const std::string jpeg = tests::rgb_jpeg();
    expect_reason(jpeg.substr(0, jpeg.size() - 2), "Premature end");
    expect_reason(jpeg.substr(0, jpeg.size() - 6), " of " + std::to_string(jpeg.size() - 6));
    // the pixels break off, but somebody has put an end there
    expect_reason(jpeg.substr(0, jpeg.size() - 8) + "\xff\xd9", "premature end of data segment");
}

// Cut before its last scan and closed again, every pixel would lack a bit.
TEST(DecodeImage, RefusesJpegWithoutAllItsScans) {
    const std::string whole = tests::progressive_jpeg();
    int cuts = 0;
    for (std::size_t at = whole.find("\xff\xda");
         (at = whole.find("\xff\xda", at + 1)) != std::string::npos; ++cuts)
        EXPECT_EQ(code_of(decode_image(whole.substr(0, at) + "\xff\xd9")), "bad-image") << at;
    EXPECT_EQ(cuts, 9);
}

// Each of them is a pass over the picture: a few bytes that take long.
TEST(DecodeImage, RefusesJpegOfVeryManyScans) {
    const std::string whole = tests::progressive_jpeg();
    const std::size_t table = whole.rfind("\xff\xc4"), end = whole.size() - 2;
    std::string many = whole.substr(0, end);
    for (int i = 0; i < 100; ++i) many += whole.substr(table, end - table);
    EXPECT_EQ(code_of(decode_image(many + "\xff\xd9")), "bad-image");
}

TEST(DecodeImage, RefusesExrWithDamagedPixels) {
    const Picture p{64, 48, std::vector<float>(64UL * 48 * 3, 0.5F)};
    std::string exr = encode_exr(p, {}).value();
    exr[exr.size() - 20] = static_cast<char>(exr[exr.size() - 20] ^ 0x55);
    EXPECT_EQ(code_of(decode_image(exr)), "bad-image");
    expect_reason(exr, "its pixels are damaged: ");  // and what the library says
}

TEST(DecodeImage, RefusesMorePixelsThanAllowed) {
    for (const std::string& whole :
         {png_of(64, 48, 1, 8, std::vector<std::uint16_t>(64UL * 48)),
          encode_exr({64, 48, std::vector<float>(64UL * 48 * 3)}, {}).value()}) {
        EXPECT_TRUE(decode_image(whole, 64 * 48));
        EXPECT_EQ(code_of(decode_image(whole, /*max_pixels=*/64 * 48 - 1)), "over-limit");
    }
}

// 65535 x 65535 pixels of 8 bytes in a file of a hundred bytes: refused by its header.
TEST(DecodeImage, RefusesBombsBeforeItTakesMemory) {
    const auto image = decode_image(png_of(65535, 65535, 4, 16, {0}));
    EXPECT_EQ(code_of(image), "over-limit");
    EXPECT_NE(image.error().message.find("65535 x 65535"), std::string::npos);
}

std::string of_bytes(const std::vector<std::uint8_t>& bytes) {
    return {bytes.begin(), bytes.end()};
}

// In one segment, in two, and in two of which one is missing.
TEST(DecodeImage, HandsOnTheProfileOfAJpeg) {
    const auto profile = icc_profile(*find_display("display-p3"));
    const std::string text = of_bytes(profile), name("ICC_PROFILE\0", 12);
    const auto with = [&](const std::string& jpeg, const std::string& place,
                          const std::string& part) {
        return tests::with_jpeg_segment(jpeg, '\xe2', name + place + part);
    };
    const std::string second = with(tests::rgb_jpeg(), "\2\2", text.substr(200));
    for (const std::string& jpeg :
         {with(tests::rgb_jpeg(), "\1\1", text), with(second, "\1\2", text.substr(0, 200))}) {
        const auto image = decode_image(jpeg);
        ASSERT_TRUE(image) << image.error().message;
        EXPECT_EQ(image->colour.icc_profile, profile);
    }
    expect_reason(second, "bad ICC marker");
}

TEST(DecodeImage, HandsOnTheProfileOfAPng) {
    const auto profile = icc_profile(*find_display("display-p3"));
    const auto image = decode_image(
        tests::with_png_chunk(png_of(1, 1, 3, 8, {1, 2, 3}), "iCCP",
                              std::string("name\0\0", 6) + tests::zlib_of(of_bytes(profile))));
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_EQ(image->colour.icc_profile, profile);
}

TEST(DecodeImage, TakesACamerasWordForAdobeRgb) {
    const auto image = decode_image(tests::with_jpeg_segment(
        tests::rgb_jpeg(), '\xe1', tests::adobe_rgb_exif("ffff", "52303300")));
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_NEAR(image->colour.transfer(0.5), std::pow(0.5, 563 / 256.0), 1e-9);
    ASSERT_TRUE(image->colour.chromaticities);
    EXPECT_EQ((*image->colour.chromaticities)[2], 0.21F);  // its green
}

// Eight ways to store the same picture, 3 x 2:  1 2 3
//                                               4 5 6
// by what Exif says row 0 and column 0 of the stored one are.
TEST(DecodeImage, TurnsWhatIsStoredTurned) {
    using Numbers = std::vector<std::uint16_t>;
    const Numbers upright{1, 2, 3, 4, 5, 6};
    const std::array<Numbers, 9> stored{upright,
                                        upright,
                                        Numbers{3, 2, 1, 6, 5, 4},   // top, right
                                        Numbers{6, 5, 4, 3, 2, 1},   // bottom, right
                                        Numbers{4, 5, 6, 1, 2, 3},   // bottom, left
                                        Numbers{1, 4, 2, 5, 3, 6},   // left, top
                                        Numbers{3, 6, 2, 5, 1, 4},   // right, top
                                        Numbers{6, 3, 5, 2, 4, 1},   // right, bottom
                                        Numbers{4, 1, 5, 2, 6, 3}};  // left, bottom
    for (int orientation = 0; orientation <= 8; ++orientation) {
        const bool is_on_its_side = orientation > 4;
        const std::string png = png_of(is_on_its_side ? 2 : 3, is_on_its_side ? 3 : 2, 1, 16,
                                       stored.at(static_cast<std::size_t>(orientation)));
        const auto image =
            decode_image(tests::with_png_chunk(png, "eXIf", tests::exif_of(orientation).substr(6)));
        ASSERT_TRUE(image) << image.error().message;
        EXPECT_EQ(image->width, 3) << orientation;
        EXPECT_EQ(image->orientation, 1);
        EXPECT_EQ(std::get<1>(image->samples), upright) << orientation;
    }
}

// 0 and 9 are none.
TEST(DecodeImage, TurnsJpegByItsExif) {
    for (const auto& [orientation, width] : {std::pair{0, 16}, {1, 16}, {3, 16}, {6, 8}, {9, 16}}) {
        const auto image = decode_image(
            tests::with_jpeg_segment(tests::rgb_jpeg(), '\xe1', tests::exif_of(orientation)));
        ASSERT_TRUE(image) << image.error().message;
        EXPECT_EQ(image->width, width) << orientation;
        const auto& bytes = std::get<0>(image->samples);  // red was on the left
        EXPECT_NEAR(bytes[0], orientation == 3 ? 20 : 200, 1) << orientation;
    }
}

}  // namespace
}  // namespace bouguer::renderer
