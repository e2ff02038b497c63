// SPDX-License-Identifier: Apache-2.0
// Drawing by arithmetic: what plots need of it. Coordinates are in pixels, (0, 0) the upper left
// corner of the upper left pixel, y downwards. Whatever falls outside is left out.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "renderer/core/vec3.h"
#include "renderer/film/raster.h"

namespace bouguer::renderer {

/// Red, green, blue as a display gets them.
using Paint = std::array<std::uint8_t, 3>;

/// Pixels that must not be drawn beyond: x in [left, right), y in [top, bottom).
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;
};

/// Where a band lies at one x.
struct BandPoint {
    double x = 0, low = 0, high = 0;  ///< low above high: y grows downwards
};

enum class TextAnchor { Left, Middle, Right };

class Canvas {
  public:
    /// Filled with `background`; sides of at least 1.
    Canvas(int width, int height, Paint background);

    /// From now on nothing outside `box` is drawn; the whole canvas at first.
    void clip_to(PixelBox box) { clip_ = box; }
    [[nodiscard]] PixelBox whole() const { return {0, 0, raster_.width, raster_.height}; }

    void fill(PixelBox box, Paint paint);
    /// Straight lines from point to point, round joints and ends, antialiased.
    void polyline(const std::vector<Vec2>& points, double width, Paint paint);
    void disk(Vec2 center, double radius, Paint paint);
    /// The area between low and high, linear between the points, whose x increase.
    void band(const std::vector<BandPoint>& points, Paint paint, double opacity);
    /// One line whose anchor is at `x`, with its baseline at `y`; every dot of the font is `size`
    /// pixels.
    void text(int x, int y, std::string_view text, Paint paint, TextAnchor anchor, int size = 1);
    /// Turned to read upwards: its middle at `y`, its baseline at `x`.
    void text_upwards(int x, int y, std::string_view text, Paint paint);

    [[nodiscard]] Raster take() && { return std::move(raster_); }

  private:
    [[nodiscard]] std::vector<std::uint8_t>::iterator pixel(int x, int y);  ///< its red
    void blend(int x, int y, Paint paint, double coverage);

    Raster raster_;
    PixelBox clip_;
};

}  // namespace bouguer::renderer
