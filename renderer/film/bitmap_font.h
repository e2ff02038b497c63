// SPDX-License-Identifier: Apache-2.0
// A small font of our own for plots: letters seven pixels high, at most five wide.
#pragma once

#include <cstddef>
#include <string_view>

namespace bouguer::renderer {

inline constexpr int kGlyphAscent = 7;   ///< rows above the baseline
inline constexpr int kGlyphDescent = 2;  ///< rows below it

/// Rows from the top, a space between two: '#' is ink, '.' is none. Seven rows, or nine when the
/// letter goes below the baseline. A character that the font lacks (all beyond ASCII) is a box.
[[nodiscard]] std::string_view glyph_rows(char character);

/// Width of a text in pixels, with a pixel between two letters.
[[nodiscard]] int text_width(std::string_view text);

/// Calls ink(x, y) for every pixel of the text: x from its left end, y downwards from the top of
/// the letters, the baseline being at kGlyphAscent.
template <class Ink>
void for_each_text_pixel(std::string_view text, const Ink& ink) {
    int left = 0;
    for (const char character : text) {
        int x = 0, y = 0, width = 0;
        for (const char cell : glyph_rows(character)) {
            if (cell == ' ') {
                x = 0, ++y;
                continue;
            }
            if (cell == '#') ink(left + x, y);
            width = ++x;
        }
        left += width + 1;
    }
}

}  // namespace bouguer::renderer
