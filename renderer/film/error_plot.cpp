// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/error_plot.h"

#include <utility>

namespace bouguer::renderer {

Plot error_plot(const std::vector<ErrorPoint>& curve) {
    PlotSeries series;
    series.name = "with its 95 % interval";
    series.paint = paints::kBlue;
    series.has_points = true;
    for (const ErrorPoint& point : curve) {
        if (!point.relative_rmse) continue;
        series.x.push_back(point.seconds);
        series.y.push_back(point.relative_rmse->value);
        series.low.push_back(point.relative_rmse->low);
        series.high.push_back(point.relative_rmse->high);
    }
    Plot plot;
    plot.title = series.x.empty() ? "No error is known yet" : "Error against run time";
    plot.x = {"run time (s)", true};
    plot.y = {"relative RMSE", true};
    if (!series.x.empty()) plot.series.push_back(std::move(series));
    return plot;
}

}  // namespace bouguer::renderer
