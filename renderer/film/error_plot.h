// SPDX-License-Identifier: Apache-2.0
// The error of a render against its run time, as a plot.
#pragma once

#include <vector>

#include "renderer/film/plot.h"
#include "renderer/report.h"

namespace bouguer::renderer {

/// Relative RMSE with its 95 % interval as a band, both axes logarithmic: a straight line of slope
/// -1/2 when samples are independent. Points whose error is not known are left out; without any,
/// the title says so.
[[nodiscard]] Plot error_plot(const std::vector<ErrorPoint>& curve);

}  // namespace bouguer::renderer
