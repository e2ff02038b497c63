// SPDX-License-Identifier: Apache-2.0
// PNG files of any kind for tests, written plainly: what encode_png() never makes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bouguer::tests {

/// 1 to 4 channels (grey, grey and alpha, RGB, RGBA) of 8 or 16 bits, not compressed. `numbers`:
/// [height][width][channels].
[[nodiscard]] std::string png_of(int width, int height, int channels, int bits,
                                 const std::vector<std::uint16_t>& numbers);

}  // namespace bouguer::tests
