// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/image_header.h"

#include <gtest/gtest.h>

#include "renderer/render.h"
#include "tests/support/jpeg_files.h"
#include "tests/support/logged_source.h"
#include "tests/support/png_writer.h"

namespace bouguer::renderer {
namespace {

/// The header says of a file what decoding it finds.
void expect_as_decoded(const std::string& bytes) {
    const auto header = read_image_header(MemorySource(bytes));
    const auto image = decode_image(bytes);
    ASSERT_TRUE(header) << header.error().message;
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_EQ(header->format, image->format);
    EXPECT_EQ(header->width, static_cast<std::uint64_t>(image->width));
    EXPECT_EQ(header->height, static_cast<std::uint64_t>(image->height));
    EXPECT_EQ(header->channels, image->channels);
    const std::uint64_t decoded = std::visit(
        [](const auto& samples) { return samples.size() * sizeof(samples[0]); }, image->samples);
    EXPECT_EQ(header->decoded_bytes(), decoded);
}

TEST(ImageHeader, SaysWhatDecodingFinds) {
    expect_as_decoded(tests::png_of(2, 1, 3, 8, {0, 128, 255, 1, 2, 3}));
    expect_as_decoded(tests::png_of(1, 2, 1, 16, {1, 65535}));
    expect_as_decoded(tests::png_of(1, 1, 2, 8, {200, 128}));
    expect_as_decoded(tests::png_of(1, 1, 4, 8, {200, 1, 2, 128}));
    expect_as_decoded(tests::rgb_jpeg());
    const auto exr = encode_exr({3, 2, std::vector<float>(18, 0.5F)}, {});
    ASSERT_TRUE(exr);
    expect_as_decoded(*exr);
}

std::string code_of(const std::string& bytes) {
    const auto header = read_image_header(MemorySource(bytes));
    return header ? "" : header.error().code;
}

// However it is cut: no header or the right one.
TEST(ImageHeader, LivesThroughFilesCutAnywhere) {
    const auto exr = encode_exr({3, 2, std::vector<float>(18, 0.5F)}, {});
    for (const std::string& whole :
         {tests::png_of(2, 1, 3, 8, {0, 128, 255, 1, 2, 3}), tests::rgb_jpeg(), *exr}) {
        const auto expected = read_image_header(MemorySource(whole));
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const auto header = read_image_header(MemorySource(whole.substr(0, length)));
            if (!header) {
                EXPECT_EQ(header.error().code, "bad-image");
            } else {
                EXPECT_EQ(header->pixels(), expected->pixels());
            }
        }
    }
}

TEST(ImageHeader, RefusesWhatIsNone) {
    EXPECT_EQ(code_of(""), "bad-image");
    EXPECT_EQ(code_of("v 0 0 0\n"), "bad-image");
    EXPECT_EQ(code_of("\x89PNG\r\n\x1a\n"), "bad-image");
    EXPECT_EQ(code_of(std::string("\xff\xd8\xff") + std::string(100'000, 'x')), "bad-image");
}

std::string reason(const std::string& bytes) {
    const auto header = read_image_header(MemorySource(bytes));
    return header ? "it is read" : header.error().message;
}

std::string little_endian(std::uint32_t number) {
    std::string bytes;
    for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>(number >> 8 * i & 255U);
    return bytes;
}

struct Channel {
    std::string name;
    std::uint32_t type = 1, sampling = 1;  ///< 0 whole numbers, 1 and 2 floats of 16 and 32 bits
};

/// The header of an EXR file of 1 x 1 pixels. `flags`: of its version field. `more`: attributes.
std::string exr_of(const std::vector<Channel>& channels, std::uint32_t flags = 0,
                   const std::string& more = "") {
    std::string list;
    for (const Channel& c : channels)
        list += c.name + '\0' + little_endian(c.type) + little_endian(0) +
                little_endian(c.sampling) + little_endian(c.sampling);
    list += '\0';
    const auto attribute = [](const std::string& name, const std::string& type,
                              const std::string& value) {
        return name + '\0' + type + '\0' + little_endian(static_cast<std::uint32_t>(value.size())) +
               value;
    };
    return "\x76\x2f\x31\x01" + little_endian(2 + flags) + attribute("channels", "chlist", list) +
           attribute("dataWindow", "box2i", std::string(16, '\0')) + more + '\0';
}

// Whole numbers are names of things. Which of several parts is meant nobody says.
TEST(ImageHeader, RefusesExrThatIsNoPicture) {
    for (const auto& channels : {std::vector<Channel>{{"Y"}},
                                 {{"A"}, {"Y", 2}},
                                 {{"B"}, {"G"}, {"R"}},
                                 {{"A"}, {"B"}, {"G"}, {"R"}}})
        EXPECT_EQ(reason(exr_of(channels)), "it is read");
    const std::vector<Channel> grey{{"Y"}};
    const std::pair<std::string, std::string> cases[]{
        {exr_of(grey, 0x1000), "several parts"},
        {exr_of(grey, 0x800), "in depth"},
        {exr_of({{"Y", 0}}), "whole numbers"},
        {exr_of({{"B"}, {"G", 0}, {"R"}}), "channel G is of whole numbers"},
        {exr_of({{"B", 1, 2}, {"G"}, {"R", 1, 2}}), "channel B has not one number a pixel"},
        {exr_of({{"BY", 1, 2}, {"RY", 1, 2}, {"Y"}}), "luminance and chroma"},
        {exr_of({{"B"}, {"G"}, {"R"}, {"Z"}}), "are B, G, R, Z"},
        {exr_of({{"light.B"}, {"light.G"}, {"light.R"}}), "are light.B"},
        {exr_of({{"B"}, {"R"}}), "are B, R"},
    };
    for (const auto& [file, words] : cases) {
        EXPECT_NE(reason(file).find(words), std::string::npos) << reason(file) << "\n" << words;
        EXPECT_EQ(code_of(file), "bad-image");
    }
}

// OpenEXR would take 2 GB for a note, or a tile, of which the file has 4 bytes.
TEST(ImageHeader, RefusesExrThatClaimsMemory) {
    const auto note = [](std::uint32_t size) {
        return std::string("note\0mine\0", 10) + little_endian(size) + "text";
    };
    EXPECT_EQ(reason(exr_of({{"Y"}}, 0, note(4))), "it is read");
    EXPECT_EQ(reason(exr_of({{"Y"}}, 0, note(0x7fffffff))), kDamagedImageHeader);
    // an int is read as four bytes, and what follows as if it followed those
    const auto number = [](std::uint32_t size) {
        return std::string("number\0int\0", 11) + little_endian(size) + "123456";
    };
    EXPECT_EQ(reason(exr_of({{"Y"}}, 0, number(4).substr(0, 19))), "it is read");
    EXPECT_EQ(reason(exr_of({{"Y"}}, 0, number(6))), kDamagedImageHeader);
    const auto texts = [](std::uint32_t claimed) {
        return std::string("texts\0stringvector\0", 19) + little_endian(12) + little_endian(0) +
               little_endian(claimed) + "1234";
    };
    EXPECT_EQ(reason(exr_of({{"Y"}}, 0, texts(4))), "it is read");
    EXPECT_EQ(reason(exr_of({{"Y"}}, 0, texts(1U << 30U))), kDamagedImageHeader);
    const auto preview = [](std::uint32_t side) {
        return std::string("preview\0preview\0", 16) + little_endian(12) + little_endian(side) +
               little_endian(side) + "rgba";
    };
    EXPECT_EQ(reason(exr_of({{"Y"}}, 0, preview(1))), "it is read");
    EXPECT_EQ(reason(exr_of({{"Y"}}, 0, preview(20'000))), kDamagedImageHeader);
    const auto tiles = [](std::uint32_t side) {
        return std::string("tiles\0tiledesc\0", 15) + little_endian(9) + little_endian(side) +
               little_endian(side) + '\0';
    };
    EXPECT_EQ(reason(exr_of({{"Y"}}, 0x200, tiles(2048))), "it is read");
    EXPECT_EQ(reason(exr_of({{"Y"}}, 0x200, tiles(2049))), "the image's tiles are too large");
}

TEST(ImageHeader, RefusesJpegOfRareKinds) {
    const auto of = [](const char* marker, char bits) {
        return std::string("\xff\xd8\xff") + marker + std::string("\0\x11", 2) + bits +
               std::string("\0\x08\0\x08\x03", 5);
    };
    for (const char* read : {"\xc0", "\xc1", "\xc2", "\xc9", "\xca"})
        EXPECT_EQ(reason(of(read, 8)), "it is read");
    for (const char* lossless : {"\xc3", "\xc7", "\xcb", "\xcf"})
        EXPECT_NE(reason(of(lossless, 8)).find("lossless"), std::string::npos);
    for (const char* hierarchical : {"\xc5", "\xc6", "\xcd", "\xce"})
        EXPECT_NE(reason(of(hierarchical, 8)).find("hierarchical"), std::string::npos);
    EXPECT_NE(reason(of("\xc1", 12)).find("12 bits"), std::string::npos);
    // all coefficients, of 16 bits each, are kept until the last scan
    EXPECT_EQ(read_image_header(MemorySource(of("\xc2", 8)))->decoded_bytes(), 8U * 8 * 3 * 3);
}

// What stands before the header is passed over and not read.
TEST(ImageHeader, ReadsLittleOfALargeFile) {
    std::string png("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x10\0\0\0\x08\0\x10\x06\0\0\0", 29);
    std::uint64_t bytes_read = 0;
    const auto header =
        read_image_header(tests::LoggedSource(png, std::uint64_t{1} << 40U, bytes_read));
    ASSERT_TRUE(header);
    EXPECT_EQ(header->width, 4096U);
    EXPECT_EQ(header->height, 2048U);
    EXPECT_EQ(header->decoded_bytes(), 4096ULL * 2048 * 4 * 2);
    EXPECT_LE(bytes_read, 8192U);

    std::string jpeg("\xff\xd8");
    for (int i = 0; i < 20; ++i) {
        jpeg += std::string("\xff\xe2\xff\xff", 4);
        jpeg.append(0xffff - 2, 'x');
    }
    jpeg += std::string("\xff\xc0\0\x11\x08\0\x40\0\x80\x03", 10);
    bytes_read = 0;
    const auto frame = read_image_header(tests::LoggedSource(jpeg, jpeg.size(), bytes_read));
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->pixels(), 64U * 128);
    EXPECT_LE(bytes_read, 22U * 4096);
}

}  // namespace
}  // namespace bouguer::renderer
