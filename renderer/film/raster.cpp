// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/raster.h"

#include <algorithm>

namespace bouguer::renderer {
namespace {

/// Rows of three dots from the top, each as an octal digit: 4 is the left dot, 1 the right.
struct Glyph {
    char letter;
    std::array<unsigned, kGlyphHeight> rows;
};
constexpr std::array kGlyphs{
    Glyph{'0', {7, 5, 5, 5, 7}}, Glyph{'1', {2, 6, 2, 2, 7}}, Glyph{'2', {7, 1, 7, 4, 7}},
    Glyph{'3', {7, 1, 7, 1, 7}}, Glyph{'4', {5, 5, 7, 1, 1}}, Glyph{'5', {7, 4, 7, 1, 7}},
    Glyph{'6', {7, 4, 7, 5, 7}}, Glyph{'7', {7, 1, 1, 1, 1}}, Glyph{'8', {7, 5, 7, 5, 7}},
    Glyph{'9', {7, 5, 7, 1, 7}}, Glyph{'d', {1, 1, 7, 5, 7}}, Glyph{'E', {7, 4, 7, 4, 7}},
};

}  // namespace

Raster::Raster(int width, int height, Rgb8 paper)
    : width_(width),
      height_(height),
      bytes_(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    fill(0, 0, width, height, paper);
}

void Raster::fill(int left, int top, int width, int height, Rgb8 colour) {
    const int right = std::min(left + width, width_), bottom = std::min(top + height, height_);
    for (int y = std::max(top, 0); y < bottom; ++y) {
        for (int x = std::max(left, 0); x < right; ++x) {
            const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                               static_cast<std::size_t>(x);
            std::copy(colour.begin(), colour.end(),
                      bytes_.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
        }
    }
}

void Raster::write(std::string_view text, int left, int top, int scale, Rgb8 colour) {
    for (const char letter : text) {
        const auto glyph = std::find_if(kGlyphs.begin(), kGlyphs.end(),
                                        [&](const Glyph& g) { return g.letter == letter; });
        for (int y = 0; glyph != kGlyphs.end() && y < kGlyphHeight; ++y) {
            for (int x = 0; x < kGlyphWidth; ++x) {
                const unsigned dot = 4U >> static_cast<unsigned>(x);
                if ((glyph->rows[static_cast<std::size_t>(y)] & dot) == 0) continue;
                fill(left + x * scale, top + y * scale, scale, scale, colour);
            }
        }
        left += kGlyphAdvance * scale;
    }
}

void Raster::write_centred(std::string_view text, int centre, int top, int scale, Rgb8 colour) {
    const int width = (static_cast<int>(text.size()) * kGlyphAdvance - 1) * scale;
    write(text, centre - width / 2, top, scale, colour);
}

}  // namespace bouguer::renderer
