// SPDX-License-Identifier: Apache-2.0
// What the error curve of a report says as a whole.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "renderer/core/result.h"
#include "renderer/report.h"

namespace bouguer::api {

/// Slope of the straight line fitted by least squares to log(rmse) against log(samples): -1/2 for
/// independent samples, steeper for stratified ones. Points whose rmse is unknown or 0 are left
/// out. Empty with fewer than three points, or when all have the same samples.
[[nodiscard]] std::optional<double> error_slope(const std::vector<renderer::ErrorPoint>& curve);

/// The points of a text that error_json() made. Internal, code "result-damaged".
[[nodiscard]] Result<std::vector<renderer::ErrorPoint>> read_error_curve(std::string_view json);

}  // namespace bouguer::api
