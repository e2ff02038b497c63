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

/// A chunk with its length and check sum.
[[nodiscard]] std::string png_chunk(const std::string& name, const std::string& data);
/// The PNG file with one more chunk, right behind IHDR; its check sum is right.
[[nodiscard]] std::string with_png_chunk(const std::string& png, const std::string& name,
                                         const std::string& data);
/// A zlib stream of `data`, not compressed [RFC 1950, 1951].
[[nodiscard]] std::string zlib_of(const std::string& data);
/// The bytes of a number, the highest first.
[[nodiscard]] std::string big_endian(std::uint32_t number, int bytes = 4);

}  // namespace bouguer::tests
