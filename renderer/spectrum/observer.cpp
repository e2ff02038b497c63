// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/observer.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace bouguer::renderer {

Observer::Observer(std::string_view name, DataTable table)
    : name_(name),
      description_(table.columns[0].description),
      table_(std::move(table)),
      y_integral_nm_(
          std::accumulate(table_.columns[1].values.begin(), table_.columns[1].values.end(), 0.0)) {
    // "CIE 1931 2-degree standard observer, x-bar": what stands before the comma is all three's.
    description_ = description_.substr(0, description_.rfind(','));
}

std::array<double, 3> Observer::at(double lambda_nm) const {
    const double position = lambda_nm - table_.wavelengths_nm.front();
    const double last = static_cast<double>(table_.wavelengths_nm.size() - 1);
    if (!(position >= 0 && position <= last)) return {};
    const auto i = static_cast<std::size_t>(std::min(std::floor(position), last - 1));
    const double t = position - static_cast<double>(i);
    std::array<double, 3> value{};
    for (std::size_t c = 0; c < 3; ++c)
        value[c] = (1 - t) * table_.columns[c].values[i] + t * table_.columns[c].values[i + 1];
    return value;
}

const std::vector<Observer>& observers() {
    // To add an observer, add its table to the data and its line here.
    static const std::vector<Observer> all{
        {"cie1931-2", read_table("observer_cie_1931_2")},
        {"cie1964-10", read_table("observer_cie_1964_10")},
        {"cie2015-2", read_table("observer_cie_2015_2")},
        {"cie2015-10", read_table("observer_cie_2015_10")},
    };
    return all;
}

std::vector<std::string_view> observer_names() {
    std::vector<std::string_view> names;
    for (const Observer& observer : observers()) names.push_back(observer.name());
    return names;
}

const Observer* find_observer(std::string_view name) {
    const auto it = std::find_if(observers().begin(), observers().end(),
                                 [&](const Observer& o) { return o.name() == name; });
    return it == observers().end() ? nullptr : &*it;
}

const Observer& standard_observer() { return observers().front(); }

}  // namespace bouguer::renderer
