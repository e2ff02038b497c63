// SPDX-License-Identifier: Apache-2.0
// The axes of a plot: where a value stands on one, and which values are written beside it.
#pragma once

#include <string>
#include <vector>

namespace bouguer::renderer {

/// The values that an axis shows, low < high; both above 0 when it is logarithmic.
struct AxisRange {
    double low = 0, high = 1;
    bool is_logarithmic = false;

    /// 0 at `low`, 1 at `high`; beyond them for values that lie outside. Of a value that has no
    /// logarithm, far below 0.
    [[nodiscard]] double position(double value) const;
};

/// A range in which all of `values` lie, its ends on ticks. What is not finite, or has no logarithm
/// on such an axis, does not count. A single value, or none, gets room around it.
[[nodiscard]] AxisRange range_of(const std::vector<double>& values, bool is_logarithmic);

/// A mark beside an axis; without a text it is a short one.
struct Tick {
    double value = 0;
    std::string text;
};

/// Some four to ten marks with texts at round values: steps of 1, 2 or 5 times a power of ten; the
/// powers of ten of a logarithmic axis, with 2 and 5 times them when these are few.
[[nodiscard]] std::vector<Tick> ticks_of(const AxisRange& range);

}  // namespace bouguer::renderer
