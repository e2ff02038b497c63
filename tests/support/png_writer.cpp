// SPDX-License-Identifier: Apache-2.0
#include "tests/support/png_writer.h"

#include <algorithm>
#include <array>

namespace bouguer::tests {
namespace {

/// CRC-32 as in the PNG specification, annex D.
std::uint32_t crc_of(const std::string& bytes) {
    std::uint32_t crc = 0xffffffffU;
    for (const char byte : bytes) {
        crc ^= static_cast<unsigned char>(byte);
        for (int k = 0; k < 8; ++k) crc = (crc & 1U) != 0 ? 0xedb88320U ^ (crc >> 1U) : crc >> 1U;
    }
    return ~crc;
}

std::uint32_t adler_of(const std::string& bytes) {
    std::uint32_t a = 1, b = 0;
    for (const char byte : bytes) {
        a = (a + static_cast<unsigned char>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16U | a;
}

}  // namespace

std::string big_endian(std::uint32_t number, int bytes) {
    std::string text;
    for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8)
        text += static_cast<char>((number >> shift) & 255U);
    return text;
}

std::string png_chunk(const std::string& type, const std::string& data) {
    return big_endian(static_cast<std::uint32_t>(data.size())) + type + data +
           big_endian(crc_of(type + data));
}

std::string zlib_of(const std::string& data) {
    std::string out = "\x78\x01";
    constexpr std::size_t kBlock = 65535;
    for (std::size_t at = 0; at < data.size(); at += kBlock) {
        const auto size = static_cast<std::uint32_t>(std::min(kBlock, data.size() - at));
        out += at + size == data.size() ? '\1' : '\0';
        for (const std::uint32_t length : {size, ~size & 0xffffU})
            out += {static_cast<char>(length & 255U), static_cast<char>(length >> 8U)};
        out += data.substr(at, size);
    }
    return out + big_endian(adler_of(data));
}

std::string png_of(int width, int height, int channels, int bits,
                   const std::vector<std::uint16_t>& numbers) {
    constexpr std::array<char, 5> kColourTypes{0, 0, 4, 2, 6};
    std::string header = big_endian(static_cast<std::uint32_t>(width)) +
                         big_endian(static_cast<std::uint32_t>(height));
    header += static_cast<char>(bits);
    header += kColourTypes[static_cast<std::size_t>(channels)];
    header += std::string(3, '\0');
    std::string rows;
    const auto row_size = static_cast<std::size_t>(width * channels);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i % row_size == 0) rows += '\0';  // not filtered
        rows += big_endian(numbers[i], bits / 8);
    }
    return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + png_chunk("IDAT", zlib_of(rows)) +
           png_chunk("IEND", "");
}

std::string with_png_chunk(const std::string& png, const std::string& name,
                           const std::string& data) {
    constexpr std::size_t kBehindHeader = 8 + 12 + 13;
    return png.substr(0, kBehindHeader) + png_chunk(name, data) + png.substr(kBehindHeader);
}

}  // namespace bouguer::tests
