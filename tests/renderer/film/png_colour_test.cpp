// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/png_colour.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/png_writer.h"

namespace bouguer::renderer {
namespace {

using tests::big_endian;
using Kind = TransferCurve::Kind;

struct Chunk {
    std::string name, data;
};

/// What a picture with these chunks says.
Result<PictureColour> colour_of(const std::vector<Chunk>& chunks) {
    std::string png = tests::png_of(1, 1, 3, 8, {1, 2, 3});
    for (const Chunk& c : chunks) png = tests::with_png_chunk(png, c.name, c.data);
    const auto file = read_png_file(png);
    if (!file) return tl::unexpected(file.error());
    return png_colour(*file);
}

void expect_refusal(const Chunk& chunk, const std::string& words) {
    const auto colour = colour_of({chunk});
    ASSERT_FALSE(colour) << words;
    EXPECT_EQ(colour.error().code, "bad-image");
    EXPECT_NE(colour.error().message.find(words), std::string::npos) << colour.error().message;
}

const Chunk kLinear{"gAMA", big_endian(100000)};
const Chunk kSrgb{"sRGB", std::string(1, '\0')};
const Chunk kProfile{"iCCP", std::string("name\0\0", 6) + tests::zlib_of("a profile")};
const Chunk kP3{"cICP", std::string("\x0c\x0d\0\1", 4)};

TEST(PngColour, SaysNothingOfAPlainFile) {
    const auto colour = colour_of({});
    ASSERT_TRUE(colour);
    EXPECT_EQ(colour->transfer.kind, Kind::Unstated);
    EXPECT_FALSE(colour->chromaticities);
    EXPECT_TRUE(colour->icc_profile.empty());
}

// A number is light^gAMA.
TEST(PngColour, ReadsGamma) {
    EXPECT_EQ(colour_of({kLinear})->transfer.kind, Kind::Linear);
    const auto usual = colour_of({{"gAMA", big_endian(45455)}});
    EXPECT_EQ(usual->transfer.kind, Kind::Power);
    EXPECT_NEAR(usual->transfer(0.5), std::pow(0.5, 2.2), 1e-5);
}

TEST(PngColour, ReadsPrimariesBehindTheWhite) {
    std::string data;
    for (const std::uint32_t v : {31270U, 32900U, 68000U, 32000U, 26500U, 69000U, 15000U, 6000U})
        data += big_endian(v);
    const auto colour = colour_of({{"cHRM", data}});
    ASSERT_TRUE(colour && colour->chromaticities);
    EXPECT_EQ(*colour->chromaticities,
              (std::array{0.68F, 0.32F, 0.265F, 0.69F, 0.15F, 0.06F, 0.3127F, 0.329F}));
    EXPECT_EQ(colour->transfer.kind, Kind::Unstated);
}

TEST(PngColour, TakesTheStrongestWord) {
    EXPECT_EQ(colour_of({kLinear, kSrgb})->transfer.kind, Kind::Srgb);
    const auto profile = colour_of({kSrgb, kLinear, kProfile});
    EXPECT_EQ(profile->transfer.kind, Kind::Unstated);
    EXPECT_EQ(profile->icc_profile.size(), 9U);
    const auto p3 = colour_of({kP3, kProfile, kSrgb, kLinear});
    EXPECT_EQ(p3->transfer.kind, Kind::Srgb);
    EXPECT_EQ((*p3->chromaticities)[0], 0.68F);
    EXPECT_TRUE(p3->icc_profile.empty());
}

// At 0.5: ((0.5 + 0.0993) / 1.0993)^(1 / 0.45), ((0.5 + 0.1115) / 1.1115)^(1 / 0.45).
TEST(PngColour, ReadsCodePoints) {
    const std::pair<char, double> curves[]{{1, 0.25972},  {4, 0.21764},  {5, 0.14359},
                                           {6, 0.25972},  {7, 0.26507},  {8, 0.5},
                                           {13, 0.21404}, {14, 0.25972}, {15, 0.25972}};
    for (const auto& [code, expected] : curves) {
        const auto colour = colour_of({{"cICP", std::string{1, code, 0, 1}}});
        ASSERT_TRUE(colour) << int{code};
        EXPECT_NEAR(colour->transfer(0.5), expected, 1e-4) << int{code};
    }
    for (const char code : {1, 4, 5, 6, 7, 8, 9, 10, 11, 12, 22})
        EXPECT_TRUE(colour_of({{"cICP", std::string{code, 13, 0, 1}}})) << int{code};
}

TEST(PngColour, NamesCodePointsThatAreNoSurface) {
    expect_refusal({"cICP", std::string{9, 16, 0, 1}}, "PQ");
    expect_refusal({"cICP", std::string{9, 18, 0, 1}}, "HLG");
    expect_refusal({"cICP", std::string{1, 13, 0, 0}}, "narrow range");
    expect_refusal({"cICP", std::string{1, 13, 1, 1}}, "not R, G, B");
    expect_refusal({"cICP", std::string{2, 13, 0, 1}}, "primaries 2");
    expect_refusal({"cICP", std::string{1, 9, 0, 1}}, "transfer characteristics 9");
}

TEST(PngColour, RefusesWordsThatMakeNoSense) {
    expect_refusal({"gAMA", big_endian(0)}, "gAMA");
    expect_refusal({"gAMA", "1"}, "gAMA");
    expect_refusal({"cHRM", "1"}, "cHRM");
    expect_refusal({"sRGB", "\4"}, "sRGB");
    expect_refusal({"cICP", "1"}, "cICP");
    expect_refusal({"iCCP", "name"}, "iCCP");
    expect_refusal({"iCCP", std::string("name\0\1", 6) + tests::zlib_of("x")}, "iCCP");
    expect_refusal({"iCCP", std::string("name\0\0not packed", 16)}, "iCCP");
    expect_refusal({"iCCP", std::string("name\0\0", 6) + tests::zlib_of("cut").substr(0, 9)},
                   "iCCP");
    expect_refusal(
        {"iCCP", std::string("name\0\0", 6) + tests::zlib_of(std::string(17U << 20U, ' '))},
        "more than 16777216 bytes");
}

}  // namespace
}  // namespace bouguer::renderer
