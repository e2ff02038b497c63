// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/picture_file.h"

#include <gtest/gtest.h>

#include "renderer/spectrum/display.h"
#include "tests/support/png_writer.h"

namespace bouguer::renderer {
namespace {

/// Colours of every kind: dim, bright, beyond every display.
Picture some_picture() { return {3, 1, {0.2F, 0.3F, 0.1F, 1e-6F, 2e-6F, 5e-6F, 40, 9, 77}}; }

TEST(LoadPicture, TakesXyzToTheBit) {
    OutputSettings output;
    output.exr_colour = FileColour::Xyz;
    const auto loaded = load_picture(encode_exr(some_picture(), output).value());
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded->picture.xyz, some_picture().xyz);
    EXPECT_EQ(loaded->picture.width, 3);
    EXPECT_FALSE(loaded->is_as_shown);
}

// Each way rounds to 24 bits, 6e-8 of the largest component; the matrices enlarge that a little.
TEST(LoadPicture, TakesEverySpaceToTheRoundingOfItsFloats) {
    const Picture expected = some_picture();
    for (const FileColour colour :
         {FileColour::Rec709, FileColour::DisplayP3, FileColour::AcesCg}) {
        OutputSettings output;
        output.exr_colour = colour;
        const auto loaded = load_picture(encode_exr(expected, output).value());
        ASSERT_TRUE(loaded);
        for (std::size_t i = 0; i < 9; ++i) {
            const float largest = expected.xyz[i - i % 3 + (i < 3 ? 1 : 2)];
            EXPECT_NEAR(loaded->picture.xyz[i], expected.xyz[i], 5e-7 * largest) << i;
        }
    }
}

// Byte 188 is linear 0.502886; the white has Y = 1.
TEST(LoadPicture, TakesPngAsShownBySrgb) {
    const auto loaded = load_picture(tests::png_of(2, 1, 3, 8, {255, 255, 255, 188, 188, 188}));
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_TRUE(loaded->is_as_shown);
    EXPECT_NEAR(loaded->picture.xyz[0], 0.3127 / 0.3290, 1e-6);
    EXPECT_NEAR(loaded->picture.xyz[1], 1, 1e-6);
    EXPECT_NEAR(loaded->picture.xyz[4], 0.502886, 1e-6);
}

TEST(LoadPicture, TakesGreyForAllThreeAndLeavesAlphaOut) {
    const auto rgb = load_picture(tests::png_of(1, 1, 3, 8, {188, 188, 188}));
    for (const auto& [channels, numbers] :
         {std::pair{1, std::vector<std::uint16_t>{188}},
          std::pair{2, std::vector<std::uint16_t>{188, 10}},
          std::pair{4, std::vector<std::uint16_t>{188, 188, 188, 0}}}) {
        const auto loaded = load_picture(tests::png_of(1, 1, channels, 8, numbers));
        ASSERT_TRUE(loaded) << channels;
        EXPECT_EQ(loaded->picture.xyz, rgb->picture.xyz) << channels;
    }
}

// What encode_png() shows of a colour within the display comes back to half a step of 8 bits, by
// the profile that it wrote into the file.
TEST(LoadPicture, KnowsTheProfileOfEveryDisplay) {
    const Picture grey{1, 1, {0.2F, 0.21F, 0.23F}};
    for (const Display& display : displays()) {
        OutputSettings output;
        output.exposure = 1;
        output.display = display.name;
        const auto loaded = load_picture(encode_png(grey, output).value());
        ASSERT_TRUE(loaded) << display.name << ": " << loaded.error().message;
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(loaded->picture.xyz[i], grey.xyz[i], 0.004) << display.name << i;
    }
}

// 128 of linear numbers is 128 / 255; the red of P3 has Y = 0.228975.
TEST(LoadPicture, TakesPngByItsCurveAndPrimaries) {
    const auto linear = load_picture(tests::with_png_chunk(
        tests::png_of(1, 1, 3, 8, {128, 128, 128}), "gAMA", tests::big_endian(100000)));
    ASSERT_TRUE(linear) << linear.error().message;
    EXPECT_NEAR(linear->picture.xyz[1], 128.0 / 255, 1e-6);
    const auto red = load_picture(tests::with_png_chunk(tests::png_of(1, 1, 3, 8, {255, 0, 0}),
                                                        "cICP", std::string("\x0c\x0d\0\1", 4)));
    ASSERT_TRUE(red) << red.error().message;
    EXPECT_NEAR(red->picture.xyz[1], 0.228975, 1e-5);
}

TEST(LoadPicture, RefusesWhatIsNoPicture) {
    EXPECT_EQ(load_picture("{}").error().kind, ErrorKind::InvalidInput);
    EXPECT_EQ(load_picture("\xff\xd8\xff").error().code, "bad-image");
    const std::string exr = encode_exr(some_picture(), {}).value();
    EXPECT_FALSE(load_picture(exr, /*max_pixels=*/2));
    EXPECT_FALSE(load_picture(exr.substr(0, exr.size() / 2)));
}

}  // namespace
}  // namespace bouguer::renderer
