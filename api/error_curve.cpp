// SPDX-License-Identifier: Apache-2.0
#include "api/error_curve.h"

#include <cmath>

namespace bouguer::api {

std::optional<double> error_slope(const std::vector<renderer::ErrorPoint>& curve) {
    double n = 0;
    double sum_x = 0;
    double sum_y = 0;
    double sum_xx = 0;
    double sum_xy = 0;
    for (const renderer::ErrorPoint& point : curve) {
        if (!point.rmse || !(point.rmse->value > 0) || !std::isfinite(point.rmse->value)) continue;
        if (point.samples == 0) continue;
        const double x = std::log(static_cast<double>(point.samples));
        const double y = std::log(point.rmse->value);
        n += 1;
        sum_x += x;
        sum_y += y;
        sum_xx += x * x;
        sum_xy += x * y;
    }
    const double spread = n * sum_xx - sum_x * sum_x;
    if (n < 3 || !(spread > 1e-9)) return std::nullopt;
    return (n * sum_xy - sum_x * sum_y) / spread;
}

}  // namespace bouguer::api
