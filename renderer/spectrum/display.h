// SPDX-License-Identifier: Apache-2.0
// From XYZ to the numbers of a display.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/spectrum/colour.h"

namespace bouguer::renderer {

/// A display: its matrix and its transfer curve. Immutable.
struct Display {
    std::string name;         ///< "srgb", "lee-9300k"
    std::string description;  ///< primaries, white, source
    Matrix3 from_xyz;         ///< XYZ -> linear R, G, B; 1 is the display's maximum
    /// Linear [0, 1] -> encoded [0, 1].
    double (*encode)(double linear);

    /// Encoded R, G, B in [0, 1]; what falls outside is clipped (`clipped` says so when it is
    /// given).
    [[nodiscard]] std::array<double, 3> show(Xyz c, bool* clipped = nullptr) const;
};

/// Null when there is no display of that name.
const Display* find_display(std::string_view name);
const std::vector<Display>& displays();

}  // namespace bouguer::renderer
