// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/picture_colour.h"

#include <gtest/gtest.h>

#include "renderer/film/icc_profile.h"
#include "renderer/film/image_file.h"
#include "renderer/spectrum/display.h"

namespace bouguer::renderer {
namespace {

using Kind = TransferCurve::Kind;
constexpr auto kSrgb = ColourEncoding::Srgb;
constexpr auto kLinear = ColourEncoding::Linear;

PictureColour of_curve(TransferCurve curve) { return {curve, {}, {}}; }
PictureColour of_primaries(const char* display) {
    return {{}, listed(find_display(display)->chromaticities), {}};
}
PictureColour of_profile(const char* display) {
    return {{}, {}, icc_profile(*find_display(display))};
}

std::optional<ColourEncoding> known(const PictureColour& colour, bool is_grey = false,
                                    ColourEncoding unstated = kSrgb) {
    const auto encoding = known_encoding(colour, unstated, is_grey);
    EXPECT_TRUE(encoding) << encoding.error().message;
    return *encoding;
}

TEST(PictureColour, KnowsNumbersThatNeedNoConversion) {
    EXPECT_EQ(known({}), kSrgb);
    EXPECT_EQ(known({}, false, kLinear), kLinear);
    EXPECT_EQ(known(of_curve({Kind::Linear})), kLinear);
    EXPECT_EQ(known(of_curve({Kind::Srgb}), false, kLinear), kSrgb);
    EXPECT_EQ(known(of_curve({Kind::Power, 2.2})), std::nullopt);
    EXPECT_EQ(known(of_primaries("srgb")), kSrgb);
    EXPECT_EQ(known(of_primaries("display-p3")), std::nullopt);
    EXPECT_EQ(known(of_primaries("display-p3"), /*is_grey=*/true), kSrgb);
    EXPECT_EQ(known(of_profile("srgb")), kSrgb);
    EXPECT_EQ(known(of_profile("rec709-linear")), kLinear);
    EXPECT_EQ(known(of_profile("display-p3")), std::nullopt);
    EXPECT_EQ(known(of_profile("acescg"), /*is_grey=*/true), std::nullopt);
}

TEST(PictureColour, KnowsWhetherAFileHasAWordOfIt) {
    EXPECT_FALSE(states_encoding({}, false));
    EXPECT_FALSE(states_encoding(of_primaries("srgb"), false));
    EXPECT_FALSE(states_encoding(of_primaries("acescg"), true));
    EXPECT_TRUE(states_encoding(of_primaries("acescg"), false));
    EXPECT_TRUE(states_encoding(of_curve({Kind::Srgb}), false));
    EXPECT_TRUE(states_encoding(of_profile("srgb"), true));
}

/// The light of a pixel.
std::array<float, 3> light(const PictureColour& colour, std::array<float, 3> pixel,
                           ColourEncoding unstated = kSrgb) {
    const auto to_light = linear_rec709(colour, unstated, /*is_grey=*/false);
    EXPECT_TRUE(to_light) << to_light.error().message;
    (*to_light)(pixel);
    return pixel;
}

void expect_near(const std::array<float, 3>& found, const std::array<double, 3>& expected,
                 double most) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], most) << k;
}

// Rec.709's red is (0.822462, 0.033194, 0.017083) in P3, which is the first column of the matrix
// that every table prints; by its primaries and by its profile.
TEST(PictureColour, TakesOtherPrimariesToRec709) {
    const std::array red{0.822462F, 0.033194F, 0.017083F};
    expect_near(light(of_primaries("display-p3"), red, kLinear), {1, 0, 0}, 1e-5);
    const auto encoded = [&](std::size_t k) { return static_cast<float>(srgb_encode(red[k])); };
    expect_near(light(of_profile("display-p3"), {encoded(0), encoded(1), encoded(2)}), {1, 0, 0},
                3e-4);
    expect_near(light(of_primaries("display-p3"), {1, 0, 0}), {1.224940, -0.042057, -0.019638},
                1e-5);
}

// Whatever white the file has.
TEST(PictureColour, KeepsWhiteAndGrey) {
    for (const char* space : {"display-p3", "acescg", "lee-9300k"}) {
        expect_near(light(of_primaries(space), {1, 1, 1}), {1, 1, 1}, 1e-5);
        expect_near(light(of_primaries(space), {0.25F, 0.25F, 0.25F}, kLinear), {0.25, 0.25, 0.25},
                    1e-5);
        const auto grey = light(of_profile(space), {0.5F, 0.5F, 0.5F});
        EXPECT_EQ(grey[0], grey[1]);
        EXPECT_EQ(grey[0], grey[2]);
    }
}

TEST(PictureColour, RefusesPrimariesThatSpanNoColours) {
    const PictureColour none{{}, std::array<float, 8>{}, {}};
    const PictureColour line{{}, std::array{0.2F, 0.2F, 0.3F, 0.3F, 0.4F, 0.4F, 0.3F, 0.3F}, {}};
    for (const auto& colour : {none, line}) {
        EXPECT_FALSE(known_encoding(colour, kSrgb, false));
        EXPECT_FALSE(linear_rec709(colour, kSrgb, false));
    }
}

}  // namespace
}  // namespace bouguer::renderer
