// SPDX-License-Identifier: Apache-2.0
// The chunks of a PNG file, before anything is made of its pixels.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "renderer/core/result.h"

namespace bouguer::renderer {

/// A PNG file that is whole.
struct PngFile {
    /// The file without all that decoding its pixels does not need: no text that unfolds to more
    /// than memory holds, nothing that a reader might turn the numbers by.
    std::string pixels_only;
    /// The data of what says how the picture is to be taken, by the chunk's name: cICP, iCCP, sRGB,
    /// gAMA, cHRM, eXIf. Into the file's bytes.
    std::map<std::string_view, std::string_view> statements;
    std::uint8_t bit_depth = 0, colour_type = 0;
};

/// Looks through all chunks and unfolds the pixels once to see that they are all there, keeping
/// none. Error{InvalidInput}, "bad-image", with the chunk and the byte where it begins: a file that
/// breaks off, a wrong check sum (of any chunk: it may be one that says what the numbers mean), a
/// missing end, chunks at the wrong place or twice, or pixels that are too few, too many or do not
/// fit their check sum. `bytes` outlives the result. Thread-safe. [PNG 3rd ed. §5, §10]
[[nodiscard]] Result<PngFile> read_png_file(std::string_view bytes);

}  // namespace bouguer::renderer
