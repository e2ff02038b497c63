// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/display.h"

#include <algorithm>
#include <cmath>

namespace bouguer::renderer {
namespace {

/// Equation 5 of [Lee et al.] as printed; displays() says what it means.
constexpr Matrix3 kLee9300K{
    {{3.5181, -1.4991, -0.5181}, {-0.8962, 1.7525, 0.0437}, {0.0798, -0.2437, 0.8931}}};

}  // namespace

double srgb_encode(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double srgb_decode(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::array<double, 3> Display::show(Xyz c, bool* clipped) const {
    std::array<double, 3> rgb = from_xyz * std::array{c.x, c.y, c.z};
    if (clipped) *clipped = false;
    for (double& v : rgb) {
        // A hair outside is the rounding of a matrix, not a colour that the display cannot show.
        constexpr double kRounding = 1e-6;
        if (clipped && !(v >= -kRounding && v <= 1 + kRounding)) *clipped = true;
        v = encode(std::clamp(std::isnan(v) ? 0.0 : v, 0.0, 1.0));
    }
    return rgb;
}

const std::vector<Display>& displays() {
    static const std::vector<Display> all{
        {"srgb",
         "IEC 61966-2-1: Rec.709 primaries, white D65 (0.3127, 0.3290), sRGB transfer curve",
         xyz_to_rec709(), &srgb_encode},
        {"lee-9300k",
         "Equation 5 of Lee et al.: primaries (0.641, 0.327), (0.272, 0.591), (0.141, 0.052), "
         "white (0.2810, 0.3110), the television white 9300 K + 27 MPCD; no adaptation, so D65 "
         "shows as a reddish white; the paper states no transfer curve: the sRGB curve is used",
         kLee9300K, &srgb_encode},
    };
    return all;
}

const Display* find_display(std::string_view name) {
    const auto it = std::find_if(displays().begin(), displays().end(),
                                 [&](const Display& display) { return display.name == name; });
    return it == displays().end() ? nullptr : &*it;
}

}  // namespace bouguer::renderer
