// SPDX-License-Identifier: Apache-2.0
// What the error curve of a report says as a whole.
#pragma once

#include <optional>
#include <vector>

#include "renderer/report.h"

namespace bouguer::api {

/// Slope of the straight line fitted by least squares to log(rmse) against log(samples): -1/2 for
/// independent samples, steeper for stratified ones. Points whose rmse is unknown or 0 are left
/// out. Empty with fewer than three points, or when all have the same samples.
[[nodiscard]] std::optional<double> error_slope(const std::vector<renderer::ErrorPoint>& curve);

}  // namespace bouguer::api
