// SPDX-License-Identifier: Apache-2.0
// Plots: lines over two axes, drawn by canvas.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/film/canvas.h"
#include "renderer/film/plot_axis.h"

namespace bouguer::renderer {

/// Colours that a series can have, told apart by people who do not see all of them
/// [Okabe and Ito 2008].
namespace paints {
inline constexpr Paint kBlue{0, 114, 178}, kVermilion{213, 94, 0}, kGreen{0, 158, 115},
    kInk{38, 42, 48};
}  // namespace paints

struct PlotAxis {
    std::string title;  ///< with the unit: "wavelength (nm)"
    bool is_logarithmic = false;
    std::optional<AxisRange> range{};  ///< empty: what the series need
    bool shows_zero = false;           ///< whether 0 belongs to such a range
    bool shows_light = false;          ///< a strip along the axis in the colours of the wavelengths
};

/// A line from point to point, as many y as x. A point that is not finite, or has no logarithm on
/// such an axis, interrupts it.
struct PlotSeries {
    std::string name;  ///< in the legend, which is there when series have names
    std::vector<double> x, y;
    std::vector<double> low, high;  ///< of a band about the line, such as an interval; or empty
    Paint paint = paints::kInk;
    bool has_points = false;  ///< whether each point is marked
};

struct Plot {
    std::string title, subtitle;  ///< the second is small, beside the first
    PlotAxis x, y;
    std::vector<PlotSeries> series;
};

inline constexpr int kPlotWidth = 640, kPlotHeight = 400;

/// The picture, kPlotWidth x kPlotHeight. The same plot gives the same bytes. Thread-safe.
[[nodiscard]] Raster draw_plot(const Plot& plot);

}  // namespace bouguer::renderer
