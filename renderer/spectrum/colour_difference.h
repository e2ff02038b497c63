// SPDX-License-Identifier: Apache-2.0
// How different two colours look.
#pragma once

#include "renderer/spectrum/colour.h"

namespace bouguer::renderer {

/// CIE 1976 L*a*b* [CIE 15:2018, 8.2.1]; L is 100 at the white.
struct Lab {
    double L = 0, a = 0, b = 0;
    bool operator==(const Lab&) const = default;
};

/// L*a*b* relative to `white`, whose components are above 0.
Lab lab_of(Xyz c, Xyz white);

/// The function f of L*a*b*, of a ratio to the white, and its derivative.
double lab_f(double ratio);
double lab_f_derivative(double ratio);

/// Distance in L*a*b*.
double delta_e_1976(const Lab& a, const Lab& b);

/// CIEDE2000 with k_L = k_C = k_H = 1 [ISO/CIE 11664-6; Sharma, Wu and Dalal 2005]. About 1 is just
/// noticeable. Symmetric. Hues that are opposite to 1e-9 degrees count as exactly opposite, so that
/// rounding does not choose between the formula's two branches there.
double delta_e_2000(const Lab& a, const Lab& b);

}  // namespace bouguer::renderer
