// SPDX-License-Identifier: Apache-2.0
// JPEG files for tests, 16 x 8 pixels: (200, 100, 50) on the left half, (20, 30, 220) on the
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

/// The same in ten scans.
inline std::string progressive_jpeg() {
    return bytes_of_hex(
        "ffd8ffe000104a46494600010100000100010000ffdb00430003020203020203030303040303040508050504"
        "04050a070706080c0a0c0c0b0a0b0b0d0e12100d0e110e0b0b1016101113141515150c0f1718161418121415"
        "14ffdb00430103040405040509050509140d0b0d141414141414141414141414141414141414141414141414"
        "1414141414141414141414141414141414141414141414141414ffc200110800080010030122000211010311"
        "01ffc400160001010100000000000000000000000000000307ffc40015010101000000000000000000000000"
        "00000506ffda000c030100021003100000018e36522dffc40014100100000000000000000000000000000010"
        "ffda00080101000105023fffc40018110002030000000000000000000000000000064381c1ffda0008010301"
        "013f01618af0ffc40018110002030000000000000000000000000000064482c2ffda0008010201013f014095"
        "4d1fffc40014100100000000000000000000000000000010ffda0008010100063f023fffc400141001000000"
        "00000000000000000000000010ffda0008010100013f213fffda000c03010002000300000010ff00ffc40014"
        "110100000000000000000000000000000000ffda0008010301013f105fffc400141101000000000000000000"
        "00000000000000ffda0008010201013f100fffc40014100100000000000000000000000000000010ffda0008"
        "010100013f103fffd9");
}

/// The JPEG file with one more segment, right behind its first marker.
inline std::string with_jpeg_segment(const std::string& jpeg, char marker,
                                     const std::string& data) {
    const std::size_t size = data.size() + 2;
    return jpeg.substr(0, 2) + '\xff' + marker + static_cast<char>(size >> 8U) +
           static_cast<char>(size & 255U) + data + jpeg.substr(2);
}

/// An Exif segment's data that says nothing but how the picture is turned.
inline std::string exif_of(int orientation) {
    return bytes_of_hex("4578696600004d4d002a000000080001011200030000000100") +
           static_cast<char>(orientation) + std::string("\0\0\0\0\0\0", 6);
}

/// An Exif segment's data, as a camera writes it: a first directory that points at Exif's, at 26;
/// that one has an entry and points at the interoperability directory, at 56, with the index.
inline std::string adobe_rgb_exif(const std::string& colour_space, const std::string& index) {
    return bytes_of_hex(
        "4578696600004d4d002a00000008"
        "0001876900040000"
        "00010000001a0000"
        "0000"
        "0002a00100030000"
        "0001" +
        colour_space +
        "0000a00500040000"
        "00010000003800000000"
        "00010001000200000004" +
        index + "00000000");
}

}  // namespace bouguer::tests
