// SPDX-License-Identifier: Apache-2.0
// What of the library is a function of wavelength: as JSON, with values, and as a plot.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "api/json_builder.h"
#include "renderer/film/plot.h"

namespace bouguer::server {

struct LibraryCurve {
    std::string_view key;              ///< of its values in the JSON: "values", "n", "k" ...
    std::function<double(double)> at;  ///< of nm
    renderer::Paint paint = renderer::paints::kInk;
};

/// A spectrum, an index, a metal or an observer.
struct LibraryItem {
    std::string_view name, description;
    api::JsonObject json;  ///< everything but the values
    std::string quantity;  ///< title of the plot's vertical axis
    std::vector<LibraryCurve> curves;
    double step_nm = 5;     ///< of the values in the JSON
    bool from_zero = true;  ///< whether the vertical axis begins at 0
};

/// The items of one kind, under /v1/library/{path}.
struct LibraryShelf {
    std::string_view path;
    std::vector<LibraryItem> items;
    /// Null when there is none of that name.
    [[nodiscard]] const LibraryItem* find(std::string_view name) const;
};

/// "spectra", "indices", "metals" and "observers".
[[nodiscard]] std::vector<LibraryShelf> library_shelves();

/// The item with its values over the rendered range.
[[nodiscard]] std::string item_json(const LibraryItem& item);
[[nodiscard]] renderer::Plot item_plot(const LibraryItem& item);

}  // namespace bouguer::server
