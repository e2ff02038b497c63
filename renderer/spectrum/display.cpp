// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/display.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bouguer::renderer {
namespace {

/// Equation 5 of [Lee et al.] as printed; displays() says what it means.
constexpr Matrix3 kLee9300K{
    {{3.5181, -1.4991, -0.5181}, {-0.8962, 1.7525, 0.0437}, {0.0798, -0.2437, 0.8931}}};

constexpr Chromaticity kD65{0.3127, 0.3290};
constexpr std::array kRec709{Chromaticity{0.64, 0.33}, Chromaticity{0.30, 0.60},
                             Chromaticity{0.15, 0.06}, kD65};
constexpr std::array kDisplayP3{Chromaticity{0.680, 0.320}, Chromaticity{0.265, 0.690},
                                Chromaticity{0.150, 0.060}, kD65};
constexpr std::array kAcesCg{Chromaticity{0.713, 0.293}, Chromaticity{0.165, 0.830},
                             Chromaticity{0.128, 0.044}, Chromaticity{0.32168, 0.33767}};
constexpr std::array kXyz{Chromaticity{1, 0}, Chromaticity{0, 1}, Chromaticity{0, 0},
                          Chromaticity{1.0 / 3, 1.0 / 3}};

/// A channel this far outside is the rounding of a matrix, not a colour that cannot be shown.
constexpr double kRounding = 1e-6;

/// Stands for infinity, so that a share of it is a number.
constexpr double kLargest = 1e300;

double identity(double linear) { return linear; }

Matrix3 from_xyz_to(const std::array<Chromaticity, 4>& c) {
    return inverse(rgb_to_xyz(c[0], c[1], c[2], c[3]));
}

/// The primaries and white that a matrix from XYZ implies.
std::array<Chromaticity, 4> implied_by(const Matrix3& from_xyz) {
    const Matrix3 to_xyz = inverse(from_xyz);
    const auto colour_of = [&](const std::array<double, 3>& rgb) {
        const auto [x, y, z] = to_xyz * rgb;
        return chromaticity({x, y, z});
    };
    return {colour_of({1, 0, 0}), colour_of({0, 1, 0}), colour_of({0, 0, 1}), colour_of({1, 1, 1})};
}

/// Mixes `rgb` with the grey of its luminance `y` (the white's is 1) until it is in [0, 1].
void desaturate(std::array<double, 3>& rgb, double y) {
    const double grey = y > 0 ? std::min(y, 1.0) : 0;  // 0 for what is not a number
    double keep = 1;  // share of the colour's difference from the grey
    for (const double v : rgb) {
        if (v < 0) keep = std::min(keep, grey / (grey - v));
        if (v > 1) keep = std::min(keep, (1 - grey) / (v - grey));
    }
    for (double& v : rgb) v = grey + keep * (v - grey);
}

std::vector<Display> make_displays() {
    const auto of_primaries = [](std::string name, std::string description,
                                 const std::array<Chromaticity, 4>& c, double (*encode)(double)) {
        return Display{std::move(name), std::move(description), from_xyz_to(c), encode, c};
    };
    // To add a display, add its line here and a sentence to displays().
    return {
        of_primaries("srgb",
                     "IEC 61966-2-1: Rec.709 primaries, white D65 (0.3127, 0.3290), sRGB transfer "
                     "curve",
                     kRec709, &srgb_encode),
        of_primaries("display-p3",
                     "SMPTE RP 431-2 primaries, white D65 (0.3127, 0.3290), sRGB transfer curve",
                     kDisplayP3, &srgb_encode),
        of_primaries("rec709-linear", "Rec.709 primaries, white D65 (0.3127, 0.3290), linear",
                     kRec709, &identity),
        of_primaries("acescg", "AP1 primaries, white (0.32168, 0.33767), linear", kAcesCg,
                     &identity),
        Display{"xyz", "CIE XYZ, linear", Matrix3{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, &identity,
                kXyz},
        Display{"lee-9300k",
                "Equation 5 of Lee et al.: primaries (0.641, 0.327), (0.272, 0.591), (0.141, "
                "0.052), white (0.2810, 0.3110), the television white 9300 K + 27 MPCD; the paper "
                "states no transfer curve: the sRGB curve is used",
                kLee9300K, &srgb_encode, implied_by(kLee9300K)},
    };
}

}  // namespace

double srgb_encode(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double srgb_decode(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

ShownColour Display::show(Xyz c, GamutMapping mapping) const {
    ShownColour shown{from_xyz * std::array{c.x, c.y, c.z}, false, false};
    for (double& v : shown.rgb) {
        v = std::isnan(v) ? 0 : std::clamp(v, -kLargest, kLargest);
        shown.out_of_gamut |= v < -kRounding;
        shown.over_range |= v > 1 + kRounding;
    }
    if (mapping == GamutMapping::Desaturate) desaturate(shown.rgb, c.y);
    for (double& v : shown.rgb) v = encode(std::clamp(v, 0.0, 1.0));
    return shown;
}

const std::vector<Display>& displays() {
    static const std::vector<Display> all = make_displays();
    return all;
}

const Display* find_display(std::string_view name) {
    const auto it = std::find_if(displays().begin(), displays().end(),
                                 [&](const Display& display) { return display.name == name; });
    return it == displays().end() ? nullptr : &*it;
}

}  // namespace bouguer::renderer
