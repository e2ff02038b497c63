// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "renderer/film/bitmap_font.h"
#include "renderer/film/canvas.h"
#include "renderer/film/image_file.h"
#include "renderer/film/picture_difference.h"

namespace bouguer::renderer {
namespace {

/// Every tenth of the colour map viridis [Smith and van der Walt 2015], sRGB.
constexpr std::array<Paint, 11> kViridis{{{0x44, 0x01, 0x54},
                                          {0x48, 0x24, 0x75},
                                          {0x41, 0x44, 0x87},
                                          {0x35, 0x5f, 0x8d},
                                          {0x2a, 0x78, 0x8e},
                                          {0x21, 0x91, 0x8c},
                                          {0x22, 0xa8, 0x84},
                                          {0x44, 0xbf, 0x70},
                                          {0x7a, 0xd1, 0x51},
                                          {0xbd, 0xdf, 0x26},
                                          {0xfd, 0xe7, 0x25}}};
constexpr Paint kUnknown{128, 128, 128}, kPaper{255, 255, 255}, kInk{0, 0, 0};

// Of the legend, in pixels.
constexpr int kMargin = 8, kBarHeight = 10, kTickHeight = 3, kGap = 3;
constexpr int kHeight = 2 * kMargin + kBarHeight + kTickHeight + kGap + kGlyphAscent;
constexpr std::string_view kTitle = "CIEDE2000";
constexpr int kLeastWidth = 200;
constexpr int kLabelStep = 2;  ///< of the numbers, CIEDE2000

/// `share` in [0, 1] of the way through the map.
Paint colour_at(double share) {
    const double place = share * (kViridis.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
    const double weight = place - static_cast<double>(below);
    Paint colour{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double mixed =
            kViridis[below][i] + weight * (kViridis[below + 1][i] - kViridis[below][i]);
        colour[i] = static_cast<std::uint8_t>(std::lround(mixed));
    }
    return colour;
}

Paint colour_of(float delta_e) {
    if (std::isnan(delta_e)) return kUnknown;
    return colour_at(std::min(delta_e / kMapLargestDeltaE, 1.0));
}

void draw_legend(Canvas& canvas, int top) {
    const int left = kMargin, right = canvas.whole().right - kMargin;
    const int width = right - text_width(kTitle) - kMargin - left;
    const int bottom = top + kMargin + kBarHeight;
    for (int x = 0; x < width; ++x)
        canvas.fill({left + x, top + kMargin, left + x + 1, bottom}, colour_at(x / (width - 1.0)));
    const int baseline = bottom + kTickHeight + kGap + kGlyphAscent;
    for (int value = 0; value <= kMapLargestDeltaE; value += kLabelStep) {
        const int x = left + static_cast<int>(std::lround(value / kMapLargestDeltaE * (width - 1)));
        canvas.fill({x, bottom, x + 1, bottom + kTickHeight}, kInk);
        canvas.text(x + 1, baseline, std::to_string(value), kInk, TextAnchor::Middle);
    }
    canvas.text(right, top + kMargin + (kBarHeight + kGlyphAscent) / 2, kTitle, kInk,
                TextAnchor::Right);
}

}  // namespace

Result<std::string> encode_difference_map(const PictureDifference& difference) {
    Canvas canvas(std::max(difference.width, kLeastWidth), difference.height + kHeight, kPaper);
    std::size_t i = 0;
    for (int y = 0; y < difference.height; ++y)
        for (int x = 0; x < difference.width; ++x)
            canvas.fill({x, y, x + 1, y + 1}, colour_of(difference.delta_e[i++]));
    draw_legend(canvas, difference.height);
    return encode_png(std::move(canvas).take());
}

}  // namespace bouguer::renderer
