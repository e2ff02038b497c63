// SPDX-License-Identifier: Apache-2.0
// A picture as a display gets it.
#pragma once

#include <cstdint>
#include <vector>

namespace bouguer::renderer {

struct Raster {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  ///< [height][width][3], sRGB, row 0 on top
};

}  // namespace bouguer::renderer
