// SPDX-License-Identifier: Apache-2.0
// Says in an image file what its numbers mean.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/spectrum/display.h"

namespace bouguer::renderer {

/// The ICC profile (version 4, matrix and transfer curves) of a display [ICC.1:2022]. Its colours
/// are taken to the profile's D50 by Bradford's transform, as the standard asks. Equal displays
/// give equal bytes: the date in it is fixed.
[[nodiscard]] std::vector<std::uint8_t> icc_profile(const Display& display);

}  // namespace bouguer::renderer
