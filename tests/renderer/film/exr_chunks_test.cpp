// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/exr_chunks.h"

#include <gtest/gtest.h>

#include "renderer/render.h"
#include "tests/support/png_writer.h"

namespace bouguer::renderer {
namespace {

std::string little_endian(std::uint64_t number, unsigned bytes) {
    std::string text;
    for (unsigned i = 0; i < bytes; ++i) text += static_cast<char>(number >> 8 * i & 255U);
    return text;
}

constexpr std::size_t kPixels = 12;
constexpr std::size_t kBytes = kPixels * 3 * 4;  ///< three floats a pixel

/// Everything of an EXR file of 12 x 1 pixels up to its only chunk, behind whose place in the table
/// it stands; its compression is ZIP.
std::string up_to_the_chunk() {
    const std::string exr = encode_exr({12, 1, std::vector<float>(kPixels * 3, 0.5F)}, {}).value();
    for (std::size_t at = 8; at < exr.size(); ++at)
        if (exr.substr(at - 8, 8) == little_endian(at, 8)) return exr.substr(0, at);
    ADD_FAILURE() << "no chunk";
    return exr;
}

/// The file with its chunk of row `row` packed as `packed` by a compression of that number.
std::string exr_of(char compression, const std::string& packed, std::uint64_t row = 0) {
    std::string exr = up_to_the_chunk();
    const std::string name("compression\0compression\0\1\0\0\0", 28);
    exr.at(exr.find(name) + name.size()) = compression;
    return exr + little_endian(row, 4) + little_endian(packed.size(), 4) + packed;
}

std::string reason(const std::string& exr) {
    const auto whole = check_exr_chunks(exr);
    return whole ? "whole" : whole.error().message;
}

// Of less than the picture OpenEXR shows what memory held before.
TEST(ExrChunks, UnfoldToAllBytesOfTheirPixels) {
    EXPECT_EQ(reason(exr_of(0, std::string(kBytes, '\0'))), "whole");
    EXPECT_NE(reason(exr_of(0, std::string(kBytes - 1, '\0'))), "whole");
    EXPECT_NE(reason(exr_of(0, std::string(kBytes + 1, '\0'))), "whole");
    // 128 and 16 zeros
    EXPECT_EQ(reason(exr_of(1, std::string("\x7f\0\x0f\0", 4))), "whole");
    EXPECT_NE(reason(exr_of(1, std::string("\x7f\0\x0e\0", 4))), "whole");
    EXPECT_NE(reason(exr_of(1, std::string("\x7f\0\x0f", 3))), "whole");
    // -3: three bytes as they are
    EXPECT_EQ(reason(exr_of(1, std::string("\x7f\0\x0c\0\xfd"
                                           "abc",
                                           8))),
              "whole");
    EXPECT_NE(reason(exr_of(1, std::string("\x7f\0\x0c\0\xfd"
                                           "ab",
                                           7))),
              "whole");
    for (const char zip : {2, 3, 5})
        EXPECT_NE(reason(exr_of(zip, tests::zlib_of(std::string(10, '\0')))), "whole") << int{zip};
    // floats of 24 bits
    EXPECT_EQ(reason(exr_of(5, tests::zlib_of(std::string(kPixels * 3 * 3, '\0')))), "whole");
}

TEST(ExrChunks, AreThereAndInTheirPlace) {
    const std::string whole = exr_of(0, std::string(kBytes, '\0'));
    EXPECT_EQ(reason(whole), "whole");
    EXPECT_NE(reason(exr_of(0, std::string(kBytes, '\0'), 1)).find("chunk 0 is damaged"),
              std::string::npos);
    EXPECT_NE(reason(whole.substr(0, whole.size() - 1)).find("chunk 0 breaks off"),
              std::string::npos);
    std::string unwritten = whole;  // as by a writer that was stopped
    const std::size_t table = up_to_the_chunk().size() - 8;
    unwritten.replace(table, 8, std::string(8, '\0'));
    EXPECT_NE(reason(unwritten).find("chunk 0 is missing"), std::string::npos);
}

}  // namespace
}  // namespace bouguer::renderer
