// SPDX-License-Identifier: Apache-2.0
// Two JPEG files for tests, 16 x 8 pixels: (200, 100, 50) on the left half, (20, 30, 220) on the
// right.
#pragma once

#include <string>
#include <string_view>

namespace bouguer::tests {

/// The bytes that hexadecimal digits stand for.
inline std::string bytes_of_hex(std::string_view hex) {
    std::string bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
        bytes += static_cast<char>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16));
    return bytes;
}

inline std::string rgb_jpeg() {
    return bytes_of_hex(
        "ffd8ffe000104a46494600010100000100010000ffdb00430002010101010102010101020202020204030202"
        "02020504040304060506060605060606070908060709070606080b08090a0a0a0a0a06080b0c0b0a0c090a0a"
        "0affdb004301020202020202050303050a0706070a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a"
        "0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0a0affc000110800080010030111000211010311"
        "01ffc4001500010100000000000000000000000000000509ffc4001410010000000000000000000000000000"
        "0000ffc40016010101010000000000000000000000000008090affc400141101000000000000000000000000"
        "00000000ffda000c03010002110311003f003c5736134da2c4d77fffd9");
}

/// The same in four inks.
inline std::string cmyk_jpeg() {
    return bytes_of_hex(
        "ffd8ffee000e41646f626500640000000000ffdb004300080606070605080707070909080a0c140d0c0b0b0c"
        "1912130f141d1a1f1e1d1a1c1c20242e2720222c231c1c2837292c30313434341f27393d38323c2e333432ff"
        "c000140800080010044311004d11005911004b1100ffc4001700010101010000000000000000000000000708"
        "0005ffc40014100100000000000000000000000000000000ffda000e0443004d0059004b00003f004870c627"
        "f49639554cffd9");
}

}  // namespace bouguer::tests
