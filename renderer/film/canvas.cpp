// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/canvas.h"

#include <algorithm>
#include <cmath>

#include "renderer/film/bitmap_font.h"

namespace bouguer::renderer {
namespace {

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double length2 = dx * dx + dy * dy;
    const double along = length2 > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / length2 : 0;
    const double t = std::clamp(along, 0.0, 1.0);
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// Pixels within `reach` of the segment; far ends are brought near, so that they fit an int.
PixelBox box_around(Vec2 a, Vec2 b, double reach) {
    const auto pixel = [](double x) { return static_cast<int>(std::clamp(x, -1e6, 1e6)); };
    return {pixel(std::floor(std::min(a.x, b.x) - reach)),
            pixel(std::floor(std::min(a.y, b.y) - reach)),
            pixel(std::ceil(std::max(a.x, b.x) + reach)),
            pixel(std::ceil(std::max(a.y, b.y) + reach))};
}

PixelBox common(PixelBox a, PixelBox b) {
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
            std::min(a.bottom, b.bottom)};
}

int anchored(int x, int width, TextAnchor anchor) {
    if (anchor == TextAnchor::Left) return x;
    return anchor == TextAnchor::Right ? x - width : x - width / 2;
}

}  // namespace

Canvas::Canvas(int width, int height, Paint background)
    : raster_{width, height, {}}, clip_{0, 0, width, height} {
    raster_.rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    fill(whole(), background);
}

std::vector<std::uint8_t>::iterator Canvas::pixel(int x, int y) {
    return raster_.rgb.begin() + 3 * (std::ptrdiff_t{y} * raster_.width + x);
}

void Canvas::blend(int x, int y, Paint paint, double coverage) {
    if (x < clip_.left || x >= clip_.right || y < clip_.top || y >= clip_.bottom) return;
    const auto rgb = pixel(x, y);
    for (int c = 0; c < 3; ++c) {
        const double mixed =
            rgb[c] * (1 - coverage) + paint[static_cast<std::size_t>(c)] * coverage;
        rgb[c] = static_cast<std::uint8_t>(std::lround(mixed));
    }
}

void Canvas::fill(PixelBox box, Paint paint) {
    const PixelBox area = common(box, clip_);
    for (int y = area.top; y < area.bottom; ++y)
        for (int x = area.left; x < area.right; ++x)
            std::copy(paint.begin(), paint.end(), pixel(x, y));
}

void Canvas::polyline(const std::vector<Vec2>& points, double width, Paint paint) {
    // The nearest segment decides, so that joints are not painted twice.
    const double reach = width / 2 + 0.5;
    const PixelBox area = common(clip_, whole());
    const int columns = std::max(area.right - area.left, 0);
    std::vector<float> coverage(static_cast<std::size_t>(columns) *
                                static_cast<std::size_t>(std::max(area.bottom - area.top, 0)));
    const auto cover = [&](int x, int y) -> float& {
        return coverage[static_cast<std::size_t>(y - area.top) * static_cast<std::size_t>(columns) +
                        static_cast<std::size_t>(x - area.left)];
    };
    for (std::size_t i = 1; i < points.size(); ++i) {
        const PixelBox box = common(area, box_around(points[i - 1], points[i], reach));
        for (int y = box.top; y < box.bottom; ++y) {
            for (int x = box.left; x < box.right; ++x) {
                const double d = distance_to_segment({x + 0.5, y + 0.5}, points[i - 1], points[i]);
                const auto here = static_cast<float>(std::clamp(reach - d, 0.0, 1.0));
                cover(x, y) = std::max(cover(x, y), here);
            }
        }
    }
    for (int y = area.top; y < area.bottom; ++y)
        for (int x = area.left; x < area.right; ++x)
            if (cover(x, y) > 0) blend(x, y, paint, cover(x, y));
}

void Canvas::disk(Vec2 center, double radius, Paint paint) {
    polyline({center, center}, 2 * radius, paint);
}

void Canvas::band(const std::vector<BandPoint>& points, Paint paint, double opacity) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const BandPoint &a = points[i - 1], &b = points[i];
        // A pixel belongs to the piece that holds its middle.
        const int first = std::max(static_cast<int>(std::ceil(a.x - 0.5)), clip_.left);
        for (int x = first; x < clip_.right && x + 0.5 < b.x; ++x) {
            const double t = (x + 0.5 - a.x) / (b.x - a.x);
            const double top = std::max<double>(a.high + t * (b.high - a.high), clip_.top);
            const double bottom = std::min<double>(a.low + t * (b.low - a.low), clip_.bottom);
            for (int y = static_cast<int>(std::floor(top)); y < bottom; ++y) {
                const double share = std::min(y + 1.0, bottom) - std::max<double>(y, top);
                blend(x, y, paint, opacity * std::max(share, 0.0));
            }
        }
    }
}

void Canvas::text(int x, int y, std::string_view text, Paint paint, TextAnchor anchor, int size) {
    const int left = anchored(x, size * text_width(text), anchor);
    const int top = y - size * kGlyphAscent;
    for_each_text_pixel(text, [&](int dx, int dy) {
        fill({left + size * dx, top + size * dy, left + size * (dx + 1), top + size * (dy + 1)},
             paint);
    });
}

void Canvas::text_upwards(int x, int y, std::string_view text, Paint paint) {
    const int bottom = y + text_width(text) / 2;
    for_each_text_pixel(
        text, [&](int dx, int dy) { blend(x - kGlyphAscent + dy, bottom - 1 - dx, paint, 1); });
}

}  // namespace bouguer::renderer
