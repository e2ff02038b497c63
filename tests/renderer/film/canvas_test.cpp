// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/canvas.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/film/bitmap_font.h"

namespace bouguer::renderer {
namespace {

constexpr Paint kWhite{255, 255, 255}, kBlack{0, 0, 0};

/// How dark a pixel of a picture in black on white is, 0 to 1.
double ink(const Raster& raster, int x, int y) {
    const auto at = 3 * static_cast<std::size_t>(y * raster.width + x);
    return 1 - raster.rgb[at] / 255.0;
}

double all_ink(const Raster& raster) {
    double sum = 0;
    for (int y = 0; y < raster.height; ++y)
        for (int x = 0; x < raster.width; ++x) sum += ink(raster, x, y);
    return sum;
}

TEST(Canvas, FillsPixelsInsideTheClipOnly) {
    Canvas canvas(8, 6, kWhite);
    canvas.clip_to({2, 1, 5, 4});
    canvas.fill({0, 0, 100, 100}, kBlack);
    const Raster raster = std::move(canvas).take();
    ASSERT_EQ(raster.rgb.size(), 3U * 8 * 6);
    EXPECT_EQ(all_ink(raster), 9);
    EXPECT_EQ(ink(raster, 2, 1), 1);
    EXPECT_EQ(ink(raster, 5, 1), 0);
}

// A horizontal line of width 2 through the edge between two rows covers both and nothing else.
TEST(Canvas, ALineCoversItsArea) {
    Canvas canvas(40, 10, kWhite);
    canvas.polyline({{-10, 5}, {50, 5}}, 2, kBlack);
    const Raster raster = std::move(canvas).take();
    EXPECT_EQ(ink(raster, 20, 4), 1);
    EXPECT_EQ(ink(raster, 20, 5), 1);
    EXPECT_EQ(all_ink(raster), 2 * 40);
}

// At any angle the ink is length times width; the round ends add a disk.
TEST(Canvas, ASlantedLineIsNeitherThinnerNorThicker) {
    Canvas canvas(100, 100, kWhite);
    canvas.polyline({{20, 30}, {80, 75}}, 3, kBlack);
    const double area = 3 * std::hypot(60, 45) + kPi * 1.5 * 1.5;
    EXPECT_NEAR(all_ink(std::move(canvas).take()) / area, 1, 0.02);
}

// Going back over itself paints nothing twice.
TEST(Canvas, JointsAreNotDarker) {
    Canvas once(50, 50, kWhite), twice(50, 50, kWhite);
    once.polyline({{10, 10}, {40, 33}}, 2, kBlack);
    twice.polyline({{10, 10}, {40, 33}, {10, 10}}, 2, kBlack);
    EXPECT_EQ(std::move(once).take().rgb, std::move(twice).take().rgb);
}

// A triangle of base 20 and height 10.
TEST(Canvas, ABandCoversItsArea) {
    Canvas canvas(40, 40, kWhite);
    canvas.band({{10, 30, 30}, {30, 30, 20}}, kBlack, 0.5);
    EXPECT_NEAR(all_ink(std::move(canvas).take()), 0.5 * 100, 1);
}

TEST(Canvas, FarAwayPointsAreHarmless) {
    Canvas canvas(10, 10, kWhite);
    canvas.polyline({{-1e300, 5}, {1e300, 5}}, 2, kBlack);
    canvas.disk({1e12, -1e12}, 3, kBlack);
    canvas.band({{-1e9, 8, 2}, {1e9, 8, 2}}, kBlack, 1);
    canvas.text(1000000, -1000000, "far", kBlack, TextAnchor::Left);
    EXPECT_EQ(std::move(canvas).take().rgb.size(), 300U);
}

// Each dot of a letter is one pixel, whichever way it is turned, and `size` squared when larger.
TEST(Canvas, TextHasTheInkOfItsLetters) {
    int dots = 0;
    for_each_text_pixel("Bouguer 1729", [&](int, int) { ++dots; });
    Canvas level(100, 20, kWhite), upright(20, 100, kWhite), large(200, 40, kWhite);
    level.text(99, 15, "Bouguer 1729", kBlack, TextAnchor::Right);
    upright.text_upwards(15, 50, "Bouguer 1729", kBlack);
    large.text(100, 30, "Bouguer 1729", kBlack, TextAnchor::Middle, 2);
    EXPECT_EQ(all_ink(std::move(level).take()), dots);
    EXPECT_EQ(all_ink(std::move(upright).take()), dots);
    EXPECT_EQ(all_ink(std::move(large).take()), 4 * dots);
}

TEST(BitmapFont, EveryGlyphIsARectangle) {
    for (int code = 0; code < 256; ++code) {
        const std::string_view rows = glyph_rows(static_cast<char>(code));
        const std::size_t width = rows.find(' ');
        const std::size_t height = (rows.size() + 1) / (width + 1);
        EXPECT_EQ(rows.size() + 1, height * (width + 1)) << code;
        EXPECT_TRUE(height == 7 || height == 9) << code;
        EXPECT_LE(width, 5U) << code;
        for (std::size_t i = 0; i < rows.size(); ++i)
            EXPECT_EQ(rows[i] == ' ', i % (width + 1) == width) << code;
    }
    for (char c = '0'; c <= '9'; ++c) EXPECT_NE(glyph_rows(c), glyph_rows('@'));
    for (char c = 'A'; c <= 'Z'; ++c) EXPECT_NE(glyph_rows(c), glyph_rows('@'));
    for (char c = 'a'; c <= 'z'; ++c) EXPECT_NE(glyph_rows(c), glyph_rows('@'));
}

TEST(BitmapFont, WidthsAddUp) {
    EXPECT_EQ(text_width(""), 0);
    EXPECT_EQ(text_width("i"), 1);
    EXPECT_EQ(text_width("ia"), 7);
}

}  // namespace
}  // namespace bouguer::renderer
