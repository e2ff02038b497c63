// SPDX-License-Identifier: Apache-2.0
// Scrambled low-discrepancy points as a pure function.
#pragma once

#include <cstdint>

#include "renderer/core/vec3.h"

namespace bouguer::renderer {

/// Point `index` of the Sobol' (0,2)-sequence, its order shuffled and its two coordinates
/// Owen-scrambled by `scramble` [Burley 2020, "Practical Hash-based Owen Scrambling"]. Uniform on
/// [0, 1)^2. Points of different `scramble` are independent; the first 2^k of one `scramble` are
/// stratified.
[[nodiscard]] Vec2 scrambled_sobol(std::uint32_t index, std::uint64_t scramble);

}  // namespace bouguer::renderer
