// SPDX-License-Identifier: Apache-2.0
// How samples are dealt into passes and tiles. Depends on settings and samples only, never on
// threads.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/render.h"

namespace bouguer::renderer {

/// 1, 1, 2, 4, ... so that a first picture comes at once and every later one halves the variance;
/// 64 at the most, so that progress is seen.
[[nodiscard]] constexpr std::uint32_t pass_samples(std::uint32_t samples_done) {
    return samples_done == 0 ? 1 : samples_done < 64 ? samples_done : 64;
}

/// The tiles of a pass over `area`, row by row, as units without holes or overlaps. Tiles are
/// smaller in passes of many samples, so that a unit stays a fraction of a second.
[[nodiscard]] std::vector<Unit> units_of_pass(const Crop& area, std::uint32_t pass,
                                              std::uint32_t first_sample,
                                              std::uint32_t num_samples);

}  // namespace bouguer::renderer
