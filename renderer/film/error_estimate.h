// SPDX-License-Identifier: Apache-2.0
// What the film claims about its own noise.
#pragma once

#include <optional>

#include "renderer/film/film.h"
#include "renderer/report.h"

namespace bouguer::renderer {

struct ErrorEstimate {
    Estimate
        rmse;  ///< root of the mean, over pixels and X, Y, Z, of the variance of the pixel's mean
    Estimate relative_rmse;   ///< rmse over the mean of X, Y, Z over the picture; 0 for a black
                              ///< picture without variance
    bool few_events = false;  ///< the variance sits in fewer than 25 pixels' worth: the interval is
                              ///< not to be trusted
};

/// The variance of a pixel's mean m from its R independent replicates with means m_r of c_r samples
/// each, n in all:
///     v = 1/(R-1) sum_r (c_r / n) (m_r - m)^2
/// (unbiased when the variance of m_r goes as 1/c_r), pooled over pixels and channels. The 95 %
/// interval comes from the spread of v over pixels, which are independent, and is taken in the
/// logarithm so that it stays positive. It covers noise only. Empty: fewer than two replicates have
/// samples, so the error is unknown.
[[nodiscard]] std::optional<ErrorEstimate> estimate_error(const Film& film);

}  // namespace bouguer::renderer
