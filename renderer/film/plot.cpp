// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/plot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/film/bitmap_font.h"
#include "renderer/spectrum/display.h"

namespace bouguer::renderer {
namespace {

constexpr Paint kPaper{255, 255, 255}, kGrid{230, 232, 235}, kFrame{120, 126, 134};
constexpr PixelBox kArea{72, 44, 616, 338};  ///< what the axes enclose
constexpr int kLightHeight = 8;              ///< of the strip below it
constexpr int kTickLength = 5, kShortTick = 3, kGap = 5;
constexpr double kLineWidth = 1.8, kPointRadius = 3;
constexpr double kBandOpacity = 0.18;
constexpr int kLegendSample = 18;
constexpr int kTitleBaseline = 28, kTitleSize = 2;

/// The colour of a wavelength, which no display can show: paler than it is, darker where the eye
/// sees less.
Paint paint_of(double lambda_nm) {
    const auto [x, y, z] = cie1931(lambda_nm);
    auto rgb = xyz_to_rec709() * std::array{x, y, z};
    const double lift = -0.5 * std::min({rgb[0], rgb[1], rgb[2], 0.0});
    for (double& c : rgb) c = std::max(c + lift, 0.0);
    // The ends fade into the dark; in between brightness is even.
    const double largest = std::max({rgb[0], rgb[1], rgb[2], 0.3});
    Paint paint{};
    for (std::size_t c = 0; c < 3; ++c) {
        paint[c] = static_cast<std::uint8_t>(std::lround(255 * srgb_encode(rgb[c] / largest)));
    }
    return paint;
}

class PlotDrawing {
  public:
    explicit PlotDrawing(const Plot& plot)
        : plot_(plot),
          canvas_(kPlotWidth, kPlotHeight, kPaper),
          x_(range(plot.x, &PlotSeries::x)),
          y_(range(plot.y, &PlotSeries::y)) {}

    Raster draw() && {
        draw_grid();
        canvas_.clip_to(kArea);
        for (const PlotSeries& series : plot_.series) draw_band(series);
        for (const PlotSeries& series : plot_.series) draw_line(series);
        canvas_.clip_to(canvas_.whole());
        draw_frame();
        if (plot_.x.shows_light) draw_light();
        draw_tick_texts();
        draw_titles();
        draw_legend();
        return std::move(canvas_).take();
    }

  private:
    [[nodiscard]] AxisRange range(const PlotAxis& axis,
                                  std::vector<double> PlotSeries::*values) const {
        if (axis.range) return *axis.range;
        std::vector<double> all;
        if (axis.shows_zero) all.push_back(0);
        for (const PlotSeries& series : plot_.series) {
            all.insert(all.end(), (series.*values).begin(), (series.*values).end());
            if (values != &PlotSeries::y) continue;
            all.insert(all.end(), series.low.begin(), series.low.end());
            all.insert(all.end(), series.high.begin(), series.high.end());
        }
        return range_of(all, axis.is_logarithmic);
    }

    [[nodiscard]] double x_pixel(double x) const {
        return kArea.left + x_.position(x) * (kArea.right - kArea.left);
    }
    [[nodiscard]] double y_pixel(double y) const {
        return kArea.bottom - y_.position(y) * (kArea.bottom - kArea.top);
    }
    /// The column or row of pixels that is nearest to an edge between two.
    static int nearest(double pixel) { return static_cast<int>(std::lround(pixel)); }

    [[nodiscard]] bool is_drawn(double x, double y) const {
        return std::isfinite(x) && std::isfinite(y) && (x > 0 || !x_.is_logarithmic) &&
               (y > 0 || !y_.is_logarithmic);
    }

    void draw_grid() {
        for (const Tick& tick : ticks_of(x_)) {
            if (tick.text.empty()) continue;
            const int x = nearest(x_pixel(tick.value));
            canvas_.fill({x, kArea.top, x + 1, kArea.bottom}, kGrid);
        }
        for (const Tick& tick : ticks_of(y_)) {
            if (tick.text.empty()) continue;
            const int y = nearest(y_pixel(tick.value));
            canvas_.fill({kArea.left, y, kArea.right, y + 1}, kGrid);
        }
    }

    void draw_band(const PlotSeries& series) {
        std::vector<BandPoint> points;
        const std::size_t size = std::min({series.x.size(), series.low.size(), series.high.size()});
        for (std::size_t i = 0; i < size; ++i) {
            if (!is_drawn(series.x[i], series.high[i])) continue;
            points.push_back(
                {x_pixel(series.x[i]), y_pixel(series.low[i]), y_pixel(series.high[i])});
        }
        canvas_.band(points, series.paint, kBandOpacity);
    }

    void draw_line(const PlotSeries& series) {
        std::vector<Vec2> points;
        const auto end_piece = [&] {
            canvas_.polyline(points, kLineWidth, series.paint);
            points.clear();
        };
        for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
            if (!is_drawn(series.x[i], series.y[i])) {
                end_piece();
                continue;
            }
            points.push_back({x_pixel(series.x[i]), y_pixel(series.y[i])});
            if (series.has_points) canvas_.disk(points.back(), kPointRadius, series.paint);
        }
        end_piece();
    }

    void draw_frame() {
        canvas_.fill({kArea.left, kArea.top, kArea.left + 1, kArea.bottom + 1}, kFrame);
        canvas_.fill({kArea.left, kArea.bottom, kArea.right + 1, kArea.bottom + 1}, kFrame);
    }

    void draw_light() {
        for (int x = kArea.left; x <= kArea.right; ++x) {
            const double share = (x - kArea.left) / static_cast<double>(kArea.right - kArea.left);
            canvas_.fill({x, kArea.bottom + 1, x + 1, kArea.bottom + 1 + kLightHeight},
                         paint_of(x_.low + share * (x_.high - x_.low)));
        }
    }

    void draw_tick_texts() {
        const int below = kArea.bottom + 1 + (plot_.x.shows_light ? kLightHeight : 0);
        for (const Tick& tick : ticks_of(x_)) {
            const int x = nearest(x_pixel(tick.value));
            const int length = tick.text.empty() ? kShortTick : kTickLength;
            canvas_.fill({x, below, x + 1, below + length}, kFrame);
            canvas_.text(x + 1, below + kTickLength + kGap + kGlyphAscent, tick.text, paints::kInk,
                         TextAnchor::Middle);
        }
        for (const Tick& tick : ticks_of(y_)) {
            const int y = nearest(y_pixel(tick.value));
            const int length = tick.text.empty() ? kShortTick : kTickLength;
            canvas_.fill({kArea.left - length, y, kArea.left, y + 1}, kFrame);
            canvas_.text(kArea.left - kTickLength - kGap, y + 1 + kGlyphAscent / 2, tick.text,
                         paints::kInk, TextAnchor::Right);
        }
    }

    void draw_titles() {
        canvas_.text(kArea.left, kTitleBaseline, plot_.title, paints::kInk, TextAnchor::Left,
                     kTitleSize);
        canvas_.text(kArea.left + kTitleSize * text_width(plot_.title) + 3 * kGap, kTitleBaseline,
                     plot_.subtitle, kFrame, TextAnchor::Left);
        canvas_.text((kArea.left + kArea.right) / 2, kPlotHeight - 14, plot_.x.title, paints::kInk,
                     TextAnchor::Middle);
        canvas_.text_upwards(22, (kArea.top + kArea.bottom) / 2, plot_.y.title, paints::kInk);
    }

    /// In the line of the title, ending where the axis ends: it never covers a curve.
    void draw_legend() {
        int right = kArea.right;
        for (auto series = plot_.series.rbegin(); series != plot_.series.rend(); ++series) {
            if (series->name.empty()) continue;
            canvas_.text(right, kTitleBaseline, series->name, paints::kInk, TextAnchor::Right);
            right -= text_width(series->name) + kGap;
            const double middle = kTitleBaseline - kGlyphAscent / 2.0;
            canvas_.polyline({{right - kLegendSample + 0.0, middle}, {right + 0.0, middle}},
                             kLineWidth, series->paint);
            right -= kLegendSample + 3 * kGap;
        }
    }

    const Plot& plot_;
    Canvas canvas_;
    AxisRange x_, y_;
};

}  // namespace

Raster draw_plot(const Plot& plot) { return PlotDrawing(plot).draw(); }

}  // namespace bouguer::renderer
