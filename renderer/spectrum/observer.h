// SPDX-License-Identifier: Apache-2.0
// Standard observers: how an eye weighs wavelengths.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "renderer/spectrum/data_table.h"

namespace bouguer::renderer {

/// Colour-matching functions x-bar, y-bar, z-bar as published at 1 nm. Immutable and thread-safe.
class Observer {
  public:
    /// `table` has the columns x, y, z at 1 nm.
    Observer(std::string_view name, DataTable table);

    [[nodiscard]] std::string_view name() const { return name_; }
    [[nodiscard]] std::string_view description() const { return description_; }
    [[nodiscard]] std::string_view source() const { return table_.columns[0].source; }

    /// x-bar, y-bar, z-bar; linear between the published values, 0 outside.
    [[nodiscard]] std::array<double, 3> at(double lambda_nm) const;
    /// Sum of y-bar over the published wavelengths, nm: what Y is normalised by, so that a constant
    /// spectral radiance of 1 has Y = 1 for every observer.
    [[nodiscard]] double y_integral_nm() const { return y_integral_nm_; }

  private:
    std::string_view name_, description_;
    DataTable table_;
    double y_integral_nm_;
};

/// Every observer: "cie1931-2" (the default), "cie1964-10", "cie2015-2", "cie2015-10".
const std::vector<Observer>& observers();
/// Their names, in that order.
std::vector<std::string_view> observer_names();
/// Null when there is none of that name.
const Observer* find_observer(std::string_view name);
/// The CIE 1931 2-degree observer.
const Observer& standard_observer();

}  // namespace bouguer::renderer
