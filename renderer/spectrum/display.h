// SPDX-License-Identifier: Apache-2.0
// From XYZ to the numbers of a display.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/spectrum/colour.h"

namespace bouguer::renderer {

/// What becomes of a colour that a display cannot show.
///
/// Clip: each channel by itself is put into [0, 1]. Hue and luminance may change; every channel
/// that can be right is.
///
/// Desaturate: the colour is mixed with the display's white at the same luminance Y, just as far as
/// every channel needs to be in [0, 1]. Luminance stays, and the hue as a straight line in linear
/// RGB has it. A colour brighter than the white becomes white.
enum class GamutMapping { Clip, Desaturate };

/// "clip", "desaturate", in the order of the enumeration.
inline constexpr std::array<std::string_view, 2> kGamutMappingNames{"clip", "desaturate"};

/// A colour as a display shows it.
struct ShownColour {
    std::array<double, 3> rgb{};  ///< encoded, in [0, 1]
    bool out_of_gamut = false;    ///< a channel was below 0: outside the triangle of primaries
    bool over_range = false;      ///< a channel was above 1: brighter than the display
};

/// A display, or any space of three primaries: its matrix and its transfer curve. Immutable.
struct Display {
    std::string name;         ///< "srgb", "lee-9300k" ...
    std::string description;  ///< primaries, white, source
    Matrix3 from_xyz;         ///< XYZ -> linear R, G, B; 1 is the display's maximum
    /// Linear [0, 1] -> encoded [0, 1].
    double (*encode)(double linear);
    /// Of red, green, blue and white (R = G = B).
    std::array<Chromaticity, 4> chromaticities;

    /// What a colour becomes. A channel that is not a number counts as 0.
    [[nodiscard]] ShownColour show(Xyz c, GamutMapping mapping = GamutMapping::Clip) const;
};

/// Null when there is no display of that name. Thread-safe.
const Display* find_display(std::string_view name);
/// Every display:
///
/// `srgb`: IEC 61966-2-1, Rec.709 primaries, white D65.
///
/// `display-p3`: the primaries of SMPTE RP 431-2, white D65, sRGB's transfer curve.
///
/// `rec709-linear`, `acescg`, `xyz`: spaces for files that go on to other programs. Their values
/// are linear. ACEScg has the primaries AP1 and a white near D60 (0.32168, 0.33767) [S-2014-004].
///
/// `lee-9300k`: equation 5 of the seed paper, a matrix "with 9300K reference white". Inverted, it
/// tells the display that the paper does not state: primaries (0.641, 0.327), (0.272, 0.591),
/// (0.141, 0.052), and R = G = B = 1 at (0.2810, 0.3110). That is the television white "9300 K + 27
/// MPCD" and neither the daylight locus (0.2849, 0.2932) nor the black body (0.2866, 0.2933) of
/// 9300 K. Unless adapted to it, a D65 white shows as (1.28, 0.95, 0.80), a reddish white. The
/// paper states no transfer curve; the sRGB curve is used.
const std::vector<Display>& displays();

/// The sRGB transfer curve [IEC 61966-2-1], linear [0, 1] -> encoded [0, 1], and its inverse.
double srgb_encode(double linear);
double srgb_decode(double encoded);

}  // namespace bouguer::renderer
