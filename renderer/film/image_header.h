// SPDX-License-Identifier: Apache-2.0
// How large the picture in a PNG, JPEG or EXR file is, without reading its pixels.
#pragma once

#include <cstdint>

#include "renderer/core/byte_source.h"
#include "renderer/film/image_decoder.h"

namespace bouguer::renderer {

struct ImageHeader {
    ImageFormat format = ImageFormat::Png;
    std::uint64_t width = 0, height = 0;
    int channels = 0;      ///< as decode_image() gives them, as far as the first bytes tell
    int sample_bytes = 1;  ///< likewise: 1, 2 or 4
    /// What decoding takes a sample besides: of a progressive JPEG, which it must have whole.
    int working_bytes = 0;

    [[nodiscard]] std::uint64_t pixels() const { return width * height; }
    /// Of memory that decoding takes.
    [[nodiscard]] std::uint64_t decoded_bytes() const {
        return pixels() * static_cast<std::uint64_t>(channels * (sample_bytes + working_bytes));
    }
};

/// Reads some KiB from the beginning of the file, and of what stands before the header of a picture
/// or in it (the segments of JPEG, the attributes of EXR) only where it ends. Of several pictures
/// the first.
/// Sides are below 2^31. Error{InvalidInput}, "bad-image": another format, no header; a JPEG that
/// is lossless, hierarchical or not of 8 bits; an EXR file of several parts, with samples in depth,
/// whose attributes are larger than it is, with tiles of more than 2^22 pixels, or with channels
/// other than Y or R, G, B, with or without A, of floats, one a pixel. [PNG 3rd ed. §11.2.1; ITU
/// T.81 §B; OpenEXR file layout]
[[nodiscard]] Result<ImageHeader> read_image_header(const ByteSource& file);

/// Error{InvalidInput}, "over-limit": more than `max_pixels`.
[[nodiscard]] Result<void> check_pixels(std::uint64_t width, std::uint64_t height,
                                        std::uint64_t max_pixels);

}  // namespace bouguer::renderer
