// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/film/image_file.h"
#include "renderer/film/picture_difference.h"
#include "renderer/film/raster.h"

namespace bouguer::renderer {
namespace {

/// Every tenth of the colour map viridis [Smith and van der Walt 2015], sRGB.
constexpr std::array<Rgb8, 11> kViridis{{{0x44, 0x01, 0x54},
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
constexpr Rgb8 kUnknown{128, 128, 128}, kPaper{255, 255, 255}, kInk{0, 0, 0};

// Of the legend, in pixels.
constexpr int kMargin = 6, kBarHeight = 10, kTickHeight = 3, kTextScale = 2;
constexpr int kHeight = 2 * kMargin + kBarHeight + kTickHeight + 2 + kTextScale * kGlyphHeight;
constexpr int kLeastWidth = 200;
constexpr int kLabelStep = 2;  ///< of the numbers, CIEDE2000

/// `share` in [0, 1] of the way through the map.
Rgb8 colour_at(double share) {
    const double place = share * (kViridis.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
    const double weight = place - static_cast<double>(below);
    Rgb8 colour{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double mixed =
            kViridis[below][i] + weight * (kViridis[below + 1][i] - kViridis[below][i]);
        colour[i] = static_cast<std::uint8_t>(std::lround(mixed));
    }
    return colour;
}

Rgb8 colour_of(float delta_e) {
    if (std::isnan(delta_e)) return kUnknown;
    return colour_at(std::min(delta_e / kMapLargestDeltaE, 1.0));
}

void draw_legend(Raster& raster, int top) {
    const int left = kMargin, width = raster.width() - 2 * kMargin - 5 * kTextScale * kGlyphAdvance;
    top += kMargin;
    for (int x = 0; x < width; ++x)
        raster.fill(left + x, top, 1, kBarHeight, colour_at(x / (width - 1.0)));
    const int text_top = top + kBarHeight + kTickHeight + 2;
    for (int value = 0; value <= kMapLargestDeltaE; value += kLabelStep) {
        const int x = left + static_cast<int>(std::lround(value / kMapLargestDeltaE * (width - 1)));
        raster.fill(x, top + kBarHeight, 1, kTickHeight, kInk);
        const std::string number = std::to_string(value);
        raster.write_centred(number, x, text_top, kTextScale, kInk);
    }
    raster.write("dE00", left + width + kTextScale * kGlyphAdvance, top, kTextScale, kInk);
}

}  // namespace

Result<std::string> encode_difference_map(const PictureDifference& difference) {
    Raster raster(std::max(difference.width, kLeastWidth), difference.height + kHeight, kPaper);
    std::size_t i = 0;
    for (int y = 0; y < difference.height; ++y)
        for (int x = 0; x < difference.width; ++x)
            raster.fill(x, y, 1, 1, colour_of(difference.delta_e[i++]));
    draw_legend(raster, difference.height);
    return encode_png(raster);
}

}  // namespace bouguer::renderer
