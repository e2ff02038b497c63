// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/exif.h"

#include <gtest/gtest.h>

#include "tests/support/jpeg_files.h"

namespace bouguer::renderer {
namespace {

using tests::bytes_of_hex;

// Header, one entry (tag, type, count, value), no further directory.
TEST(Exif, TellsTheOrientationInBothByteOrders) {
    EXPECT_EQ(exif_orientation(bytes_of_hex("4d4d002a00000008"
                                            "0001011200030000000100060000"
                                            "00000000")),
              6);
    EXPECT_EQ(exif_orientation(bytes_of_hex("49492a0008000000"
                                            "0100120103000100000008000000"
                                            "00000000")),
              8);
    // as a number of 32 bits, behind the prefix
    EXPECT_EQ(exif_orientation(bytes_of_hex("457869660000"
                                            "49492a0008000000"
                                            "0100120104000100000003000000"
                                            "00000000")),
              3);
}

TEST(Exif, TakesEverythingElseForUpright) {
    for (const int none : {0, 9, 255}) EXPECT_EQ(exif_orientation(tests::exif_of(none)), 1) << none;
    EXPECT_EQ(exif_orientation(""), 1);
    EXPECT_EQ(exif_orientation("no Exif at all"), 1);
    const std::string whole = tests::exif_of(5);
    EXPECT_EQ(exif_orientation(whole), 5);
    for (std::size_t size = 0; size < whole.size() - 8; ++size)
        EXPECT_EQ(exif_orientation(std::string_view(whole).substr(0, size)), 1) << size;
}

TEST(Exif, KnowsCamerasThatWriteAdobeRgb) {
    EXPECT_TRUE(is_adobe_rgb(tests::adobe_rgb_exif("ffff", "52303300")));   // uncalibrated, R03
    EXPECT_FALSE(is_adobe_rgb(tests::adobe_rgb_exif("0001", "52393800")));  // sRGB, R98
    EXPECT_TRUE(is_adobe_rgb(tests::adobe_rgb_exif("0002", "52393800")));
    EXPECT_FALSE(is_adobe_rgb(tests::exif_of(1)));
    EXPECT_FALSE(is_adobe_rgb(""));
}

}  // namespace
}  // namespace bouguer::renderer
