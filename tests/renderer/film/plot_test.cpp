// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "renderer/film/error_plot.h"
#include "renderer/film/image_decoder.h"
#include "renderer/film/image_file.h"

namespace bouguer::renderer {
namespace {

std::string texts(const std::vector<Tick>& ticks) {
    std::string text;
    for (const Tick& tick : ticks) text += tick.text + " ";
    return text;
}

std::string texts(double low, double high, bool is_logarithmic) {
    return texts(ticks_of({low, high, is_logarithmic}));
}

TEST(PlotAxis, TicksAreRound) {
    EXPECT_EQ(texts(360, 830, false), "400 450 500 550 600 650 700 750 800 ");
    EXPECT_EQ(texts(0, 1, false), "0.0 0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8 0.9 1.0 ");
    EXPECT_EQ(texts(-0.02, 0.02, false),
              "-0.020 -0.015 -0.010 -0.005 0.000 0.005 0.010 0.015 0.020 ");
    EXPECT_EQ(texts(0, 4e12, false), "0 5e+11 1e+12 1.5e+12 2e+12 2.5e+12 3e+12 3.5e+12 4e+12 ");
}

TEST(PlotAxis, LogarithmicTicksAreThePowersOfTen) {
    std::string texts_only;
    for (const Tick& tick : ticks_of({1e-3, 10, true}))
        if (!tick.text.empty()) texts_only += tick.text + " ";
    EXPECT_EQ(texts_only, "0.001 0.01 0.1 1 10 ");
    // 1 to 9 in each of four decades, and 10
    EXPECT_EQ(ticks_of({1e-3, 10, true}).size(), 4U * 9 + 1);
    EXPECT_EQ(texts(1, 10, true), "1 2   5     10 ");
}

TEST(PlotAxis, RangesEndOnTicks) {
    const AxisRange linear = range_of({0.13, 0.87, NAN}, false);
    EXPECT_NEAR(linear.low, 0.1, 1e-12);
    EXPECT_NEAR(linear.high, 0.9, 1e-12);
    const AxisRange logarithmic = range_of({0.13, 87, 0, -1, INFINITY}, true);
    EXPECT_NEAR(logarithmic.low, 0.1, 1e-12);
    EXPECT_NEAR(logarithmic.high, 100, 1e-9);
    EXPECT_EQ(logarithmic.position(logarithmic.low), 0);
    EXPECT_NEAR(logarithmic.position(std::sqrt(10)), 0.5, 1e-12);
    EXPECT_LT(logarithmic.position(0), -100);
}

TEST(PlotAxis, OneValueAndNoneHaveRoom) {
    for (const bool is_logarithmic : {false, true}) {
        for (const std::vector<double>& values :
             {std::vector<double>{}, {0.0}, {5.0}, {-5.0}, {1e-300}, {1e300}}) {
            const AxisRange range = range_of(values, is_logarithmic);
            EXPECT_LT(range.low, range.high);
            EXPECT_LT(ticks_of(range).size(), 50U);
        }
    }
}

Plot sample_plot() {
    Plot plot{"A line",
              "",
              {"x", false, AxisRange{0, 10, false}},
              {"y", false, AxisRange{0, 1, false}},
              {}};
    plot.series = {{"", {0, 10}, {0, 1}, {}, {}, paints::kVermilion}};
    return plot;
}

bool has_paint(const Raster& raster, int x, int y, Paint paint) {
    const auto at = 3 * static_cast<std::size_t>(y * raster.width + x);
    return raster.rgb[at] == paint[0] && raster.rgb[at + 1] == paint[1] &&
           raster.rgb[at + 2] == paint[2];
}

int count_paint(const Raster& raster, Paint paint) {
    int count = 0;
    for (int y = 0; y < raster.height; ++y)
        for (int x = 0; x < raster.width; ++x) count += has_paint(raster, x, y, paint) ? 1 : 0;
    return count;
}

// The diagonal goes through the middle of the plot's area, (72 + 616) / 2 and (44 + 338) / 2.
TEST(Plot, DrawsWhereTheAxesSay) {
    const Raster raster = draw_plot(sample_plot());
    EXPECT_EQ(raster.width, kPlotWidth);
    EXPECT_EQ(raster.height, kPlotHeight);
    EXPECT_TRUE(has_paint(raster, 344, 190, paints::kVermilion) ||
                has_paint(raster, 343, 191, paints::kVermilion));
    EXPECT_FALSE(has_paint(raster, 344, 100, paints::kVermilion));
    EXPECT_EQ(draw_plot(sample_plot()).rgb, raster.rgb);
}

TEST(Plot, WhatIsNoNumberInterruptsTheLine) {
    Plot plot = sample_plot();
    plot.series[0].x = {0, 1, 5, 9, 10};
    const double y = (338 - 190.5) / (338 - 44);  // along the middle of a row of pixels
    plot.series[0].y = {y, y, NAN, y, y};
    const Raster raster = draw_plot(plot);
    EXPECT_GT(count_paint(raster, paints::kVermilion), 0);
    for (int row = 44; row < 338; ++row)
        EXPECT_FALSE(has_paint(raster, 344, row, paints::kVermilion));
}

TEST(Plot, LongTitlesAndWildValuesAreHarmless) {
    Plot plot{std::string(500, 'W'),
              std::string(500, 'W'),
              {std::string(500, 'W'), true},
              {std::string(500, 'W'), true},
              {}};
    constexpr double kMax = std::numeric_limits<double>::max();
    plot.series = {{std::string(500, 'W'),
                    {0, -1, 1e-300, kMax},
                    {kMax, 1, 1e-300, NAN},
                    {0, 0, 0, 0},
                    {kMax, kMax, kMax, INFINITY}}};
    plot.series[0].has_points = true;
    EXPECT_EQ(draw_plot(plot).rgb.size(), 3U * kPlotWidth * kPlotHeight);
    EXPECT_EQ(draw_plot(Plot{}).rgb.size(), 3U * kPlotWidth * kPlotHeight);
}

TEST(Plot, BecomesAPng) {
    const Raster raster = draw_plot(sample_plot());
    const auto png = encode_png(raster);
    ASSERT_TRUE(png);
    const auto back = decode_image(*png);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->width, kPlotWidth);
    EXPECT_EQ(back->height, kPlotHeight);
    EXPECT_EQ(std::get<std::vector<std::uint8_t>>(back->samples), raster.rgb);
}

TEST(ErrorPlot, LeavesOutWhatIsNotKnown) {
    std::vector<ErrorPoint> curve(3);
    EXPECT_TRUE(error_plot(curve).series.empty());
    EXPECT_EQ(error_plot(curve).title, "No error is known yet");
    curve[2].seconds = 4;
    curve[2].relative_rmse = Estimate{0.02, 0.01, 0.03};
    const Plot plot = error_plot(curve);
    ASSERT_EQ(plot.series.size(), 1U);
    EXPECT_EQ(plot.series[0].x, std::vector<double>{4});
    EXPECT_EQ(plot.series[0].low, std::vector<double>{0.01});
    EXPECT_EQ(plot.series[0].high, std::vector<double>{0.03});
}

}  // namespace
}  // namespace bouguer::renderer
