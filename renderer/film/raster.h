// SPDX-License-Identifier: Apache-2.0
// A small drawing surface: rectangles and a few letters, for pictures of numbers.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace bouguer::renderer {

/// sRGB-encoded.
using Rgb8 = std::array<std::uint8_t, 3>;

/// Size of a letter in its own dots, and from one letter to the next.
inline constexpr int kGlyphWidth = 3, kGlyphHeight = 5, kGlyphAdvance = 4;

/// What is drawn outside is cut off.
class Raster {
  public:
    Raster(int width, int height, Rgb8 paper);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    /// [height][width][3], row 0 on top.
    [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }

    void fill(int left, int top, int width, int height, Rgb8 colour);
    /// Digits, "d" and "E"; others are left blank. `scale` pixels a dot.
    void write(std::string_view text, int left, int top, int scale, Rgb8 colour);
    void write_centred(std::string_view text, int centre, int top, int scale, Rgb8 colour);

  private:
    int width_, height_;
    std::vector<std::uint8_t> bytes_;
};

}  // namespace bouguer::renderer
