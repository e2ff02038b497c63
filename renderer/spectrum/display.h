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

    /// Encoded R, G, B in [0, 1]; what falls outside is clipped channel by channel (`clipped` says
    /// so when it is given).
    [[nodiscard]] std::array<double, 3> show(Xyz c, bool* clipped = nullptr) const;
};

/// Null when there is no display of that name. Thread-safe.
const Display* find_display(std::string_view name);
/// Every display:
///
/// `srgb`: IEC 61966-2-1, Rec.709 primaries, white D65.
///
/// `lee-9300k`: equation 5 of the seed paper, a matrix "with 9300K reference white". Inverted, it
/// tells the display that the paper does not state: primaries (0.641, 0.327), (0.272, 0.591),
/// (0.141, 0.052), and R = G = B = 1 at (0.2810, 0.3110). That is the television white "9300 K + 27
/// MPCD" and neither the daylight locus (0.2849, 0.2932) nor the black body (0.2866, 0.2933) of
/// 9300 K. Nothing is adapted: a D65 white shows as (1.28, 0.95, 0.80), a reddish white. The paper
/// states no transfer curve; the sRGB curve is used.
const std::vector<Display>& displays();

/// The sRGB transfer curve [IEC 61966-2-1], linear [0, 1] -> encoded [0, 1], and its inverse.
double srgb_encode(double linear);
double srgb_decode(double encoded);

}  // namespace bouguer::renderer
