// SPDX-License-Identifier: Apache-2.0
#include "renderer/textures/image_texture.h"

#include <gtest/gtest.h>

#include "renderer/spectrum/display.h"
#include "renderer/spectrum/primary_reflectances.h"
#include "renderer/spectrum/smooth_reflectance.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

using Floats = std::vector<float>;

/// A grey picture `width` texels wide.
TextureImagePtr grey(int width, Floats values) {
    auto image = std::make_shared<TextureImage>();
    image->width = width;
    image->height = static_cast<int>(values.size()) / width;
    image->samples = std::move(values);
    return image;
}

TexturePtr linear(TextureImagePtr image, TextureFilter filter = TextureFilter::Bilinear,
                  TextureWrap wrap = TextureWrap::Repeat) {
    return image_texture(std::move(image), {ColourEncoding::Linear, filter, wrap, {}}).value();
}

float value_at(const TexturePtr& texture, Real u, Real v) { return texture->at({u, v})[0]; }

// 1 2 above 3 4: row 0 is on top, v goes up.
TEST(ImageTexture, HasItsFirstRowOnTop) {
    const TexturePtr texture = linear(grey(2, {1, 2, 3, 4}), TextureFilter::Nearest);
    EXPECT_EQ(value_at(texture, 0.1, 0.9), 1);
    EXPECT_EQ(value_at(texture, 0.9, 0.9), 2);
    EXPECT_EQ(value_at(texture, 0.1, 0.1), 3);
    EXPECT_EQ(value_at(texture, 0.9, 0.1), 4);
}

// At a texel's centre its own value; half way between centres the mean.
TEST(ImageTexture, IsLinearBetweenCentres) {
    const TexturePtr texture = linear(grey(2, {1, 2, 3, 4}));
    EXPECT_FLOAT_EQ(value_at(texture, 0.25, 0.75), 1);
    EXPECT_FLOAT_EQ(value_at(texture, 0.75, 0.25), 4);
    EXPECT_FLOAT_EQ(value_at(texture, 0.5, 0.75), 1.5);
    EXPECT_FLOAT_EQ(value_at(texture, 0.25, 0.5), 2);
    EXPECT_FLOAT_EQ(value_at(texture, 0.5, 0.5), 2.5);
    EXPECT_FLOAT_EQ(value_at(texture, 0.375, 0.75), 1.25);
}

// Beyond the border: the other border, the same one, or the way back.
TEST(ImageTexture, GoesOnByItsWrap) {
    const Floats row{1, 2, 5, 9};
    const auto of = [&](TextureWrap wrap, TextureFilter filter = TextureFilter::Bilinear) {
        return linear(grey(4, row), filter, wrap);
    };
    EXPECT_FLOAT_EQ(value_at(of(TextureWrap::Repeat), 0, 0.5), 5);  // between 9 and 1
    EXPECT_FLOAT_EQ(value_at(of(TextureWrap::Repeat), 1.375, 0.5), 2);
    EXPECT_FLOAT_EQ(value_at(of(TextureWrap::Repeat), -2.375, 0.5), 5);
    EXPECT_FLOAT_EQ(value_at(of(TextureWrap::Clamp), 0, 0.5), 1);
    EXPECT_FLOAT_EQ(value_at(of(TextureWrap::Clamp), -7, 0.5), 1);
    EXPECT_FLOAT_EQ(value_at(of(TextureWrap::Clamp), 7, 0.5), 9);
    EXPECT_FLOAT_EQ(value_at(of(TextureWrap::Mirror), 1, 0.5), 9);
    EXPECT_FLOAT_EQ(value_at(of(TextureWrap::Mirror), 1.375, 0.5), 5);
    EXPECT_FLOAT_EQ(value_at(of(TextureWrap::Mirror), -0.375, 0.5), 2);
    EXPECT_FLOAT_EQ(value_at(of(TextureWrap::Mirror, TextureFilter::Nearest), 2, 0.5), 1);
}

// The sum over a fine lattice is the mean of the texels, whatever filter and wrap.
TEST(ImageTexture, KnowsItsMean) {
    for (const auto filter : {TextureFilter::Bilinear, TextureFilter::Nearest}) {
        for (const auto wrap : {TextureWrap::Repeat, TextureWrap::Clamp, TextureWrap::Mirror}) {
            const TexturePtr texture = linear(grey(3, {1, 2, 6, 0, 4, 5}), filter, wrap);
            EXPECT_EQ(texture->mean()[0], 3);
            double sum = 0;
            constexpr int kSide = 120;
            for (int i = 0; i < kSide * kSide; ++i)
                sum += value_at(texture, (i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide);
            EXPECT_NEAR(sum / (kSide * kSide), 3, 1e-4);
        }
    }
}

TEST(ImageTexture, DecodesSrgb) {
    auto image = std::make_shared<TextureImage>();
    image->width = 4;
    image->height = 1;
    image->samples = std::vector<std::uint8_t>{0, 10, 128, 255};
    const auto texture =
        image_texture(image, {ColourEncoding::Srgb, TextureFilter::Nearest, {}, {}}).value();
    EXPECT_EQ(value_at(texture, 0.1, 0.5), 0);
    EXPECT_FLOAT_EQ(value_at(texture, 0.3, 0.5), 10 / 255.0 / 12.92);  // the straight part
    EXPECT_FLOAT_EQ(value_at(texture, 0.6, 0.5), 0.21586050);  // ((128/255 + .055)/1.055)^2.4
    EXPECT_EQ(value_at(texture, 0.9, 0.5), 1);
    image->samples = std::vector<std::uint16_t>{0, 0, 32768, 65535};
    const auto fine =
        image_texture(image, {ColourEncoding::Linear, TextureFilter::Nearest, {}, {}}).value();
    EXPECT_FLOAT_EQ(value_at(fine, 0.6, 0.5), 32768 / 65535.0);
}

// Light is averaged, not its encoding: half black and half white is 0.5 and not 0.214.
TEST(ImageTexture, FiltersLight) {
    auto image = std::make_shared<TextureImage>();
    image->width = 2;
    image->height = 1;
    image->samples = std::vector<std::uint8_t>{0, 255};
    const auto texture = image_texture(image, {}).value();
    EXPECT_FLOAT_EQ(value_at(texture, 0.5, 0.5), 0.5);
    EXPECT_FLOAT_EQ(texture->mean()[0], 0.5);
}

TEST(ImageTexture, GivesGreyOneSpectrumAndColourThree) {
    EXPECT_EQ(linear(grey(1, {0.5F}))->spectra().size(), 1U);
    EXPECT_EQ(linear(grey(1, {0.5F}))->spectra()[0]->at(500), 1);
    auto image = std::make_shared<TextureImage>();
    image->width = image->height = 1;
    image->channels = 3;
    image->samples = Floats{0.1F, 0.6F, 0.3F};
    const TexturePtr texture = linear(image);
    const auto& primaries = srgb_primary_reflectances();
    EXPECT_EQ(texture->spectra(), (std::vector<SpectrumPtr>(primaries.begin(), primaries.end())));
    EXPECT_EQ(texture->at({0.3, 0.3}), (TextureWeights{0.1F, 0.6F, 0.3F}));
    EXPECT_EQ(texture->memory_bytes(), 12U);
}

TEST(ImageTexture, RefusesEncodedNumbersAboveOne) {
    auto image = std::make_shared<TextureImage>(*grey(2, {0, 1.5F}));
    image->largest = 1.5;
    image->largest_at = {1, 0};
    const auto texture = image_texture(image, {});
    ASSERT_FALSE(texture);
    EXPECT_EQ(texture.error().code, "out-of-range");
    EXPECT_NE(texture.error().message.find("column 1, row 0"), std::string::npos);
}

TEST(ImageTexture, TakesTheUsualEncodingOfAFormat) {
    EXPECT_EQ(usual_encoding(ImageFormat::Exr), ColourEncoding::Linear);
    EXPECT_EQ(usual_encoding(ImageFormat::Png), ColourEncoding::Srgb);
    EXPECT_EQ(usual_encoding(ImageFormat::Jpeg), ColourEncoding::Srgb);
}

}  // namespace
}  // namespace bouguer::renderer
