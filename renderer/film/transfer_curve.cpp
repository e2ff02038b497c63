// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/transfer_curve.h"

#include <cmath>

#include "renderer/spectrum/display.h"

namespace bouguer::renderer {

double TransferCurve::operator()(double number) const {
    // The constants of H.273 to the digits that make the two pieces meet.
    constexpr double kAlpha709 = 1.09929682680944, kBeta709 = 0.018053968510807;
    constexpr double kAlpha240 = 1.111572195921731, kBeta240 = 0.022821585529445;
    switch (kind) {
        case Kind::Linear:
            return number;
        case Kind::Power:
            return std::pow(number, exponent);
        case Kind::Bt709:
            return number < 4.5 * kBeta709
                       ? number / 4.5
                       : std::pow((number + kAlpha709 - 1) / kAlpha709, 1 / 0.45);
        case Kind::Smpte240:
            return number < 4 * kBeta240 ? number / 4
                                         : std::pow((number + kAlpha240 - 1) / kAlpha240, 1 / 0.45);
        case Kind::Unstated:
        case Kind::Srgb:
            break;
    }
    return srgb_decode(number);
}

}  // namespace bouguer::renderer
