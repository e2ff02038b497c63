// SPDX-License-Identifier: Apache-2.0
// What an eye does with the colour of the light: colours seen under one white, as they would be
// under another.
#pragma once

#include <array>
#include <string_view>

#include "renderer/spectrum/colour.h"

namespace bouguer::renderer {

/// None: XYZ is shown as it is. Bradford [Lam 1985; ICC.1:2022, annex E]. CAT16, its degree of
/// adaptation 1 [Li et al. 2017].
enum class Adaptation { None, Bradford, Cat16 };

/// "none", "bradford", "cat16", in the order of the enumeration.
inline constexpr std::array<std::string_view, 3> kAdaptationNames{"none", "bradford", "cat16"};

/// The linear map of XYZ that takes `from` to `to`: in the method's cone space each response is
/// scaled (von Kries). Luminances of the two whites do not matter, only their chromaticities: a
/// `from` of Y = 1 becomes a `to` of Y = 1. Both can_be_white(). None: the identity.
Matrix3 adaptation_matrix(Adaptation method, Chromaticity from, Chromaticity to);

/// Whether an eye could take the colour for white: its y is at least 1e-3 and all three responses
/// of the method's cones are above 0, as those of every light but of very pure reds and blues are.
bool can_be_white(Adaptation method, Chromaticity c);

}  // namespace bouguer::renderer
