// SPDX-License-Identifier: Apache-2.0
// Tristimulus values and the conventions of colour: stated here once.
#pragma once

#include <array>

#include "renderer/spectrum/observer.h"
#include "renderer/spectrum/spectrum.h"

namespace bouguer::renderer {

/// The rendered range. Outside it the CIE 1931 observer is below 1e-5 of its peak.
inline constexpr double kLambdaMin_nm = 360;
inline constexpr double kLambdaMax_nm = 830;

/// Integral of the CIE 1931 2-degree y-bar at 1 nm, 360..830 nm [CIE 018:2019]; in nm. Y is
/// normalised by it, so a constant spectral radiance of 1 has Y = 1. Luminance in cd/m^2 is Y *
/// kMaxLuminousEfficacy * kYIntegral_nm.
inline constexpr double kYIntegral_nm = 106.8569171;
inline constexpr double kMaxLuminousEfficacy_lm_per_W = 683.002;

/// CIE 1931 tristimulus values, normalised as above.
struct Xyz {
    double x = 0, y = 0, z = 0;
    bool operator==(const Xyz&) const = default;
    constexpr Xyz& operator+=(Xyz b) { return *this = {x + b.x, y + b.y, z + b.z}; }
};
constexpr Xyz operator+(Xyz a, Xyz b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Xyz operator*(Xyz a, double s) { return {a.x * s, a.y * s, a.z * s}; }

struct Chromaticity {
    double x = 0, y = 0;
};
/// (x, y) of a colour; (0, 0) for black.
Chromaticity chromaticity(Xyz c);

/// Three rows of a linear map of colours.
using Matrix3 = std::array<std::array<double, 3>, 3>;
std::array<double, 3> operator*(const Matrix3& m, const std::array<double, 3>& v);
Matrix3 operator*(const Matrix3& a, const Matrix3& b);
/// Inverse; the caller knows that it exists.
Matrix3 inverse(const Matrix3& m);

/// Colour-matching functions x-bar, y-bar, z-bar of the CIE 1931 2-degree observer, linear between
/// the 1 nm values; 0 outside.
std::array<double, 3> cie1931(double lambda_nm);

/// XYZ of a spectral radiance by the rectangle rule on 360, 360 + step, ... nm.
Xyz xyz_of(const Spectrum& radiance, double step_nm = 1,
           const Observer& observer = standard_observer());
/// XYZ of a reflectance (or transmittance) under an illuminant, relative to that illuminant's Y.
Xyz xyz_of_reflectance(const Spectrum& reflectance, const Spectrum& illuminant, double step_nm = 1,
                       const Observer& observer = standard_observer());

/// The matrix of a display: its primaries' and its white's chromaticities; RGB (1, 1, 1) has Y = 1.
Matrix3 rgb_to_xyz(Chromaticity red, Chromaticity green, Chromaticity blue, Chromaticity white);

/// Linear Rec.709 / sRGB primaries, D65 white [IEC 61966-2-1].
const Matrix3& xyz_to_rec709();
const Matrix3& rec709_to_xyz();

}  // namespace bouguer::renderer
