// SPDX-License-Identifier: Apache-2.0
// A picture that may become a texture: checked, without alpha, kept as its file keeps it.
#pragma once

#include <memory>
#include <optional>

#include "renderer/film/image_decoder.h"

namespace bouguer::renderer {

/// A place in a picture: column and row from 0, row 0 on top.
struct TexelPlace {
    int column = 0, row = 0;
};

/// Every number is finite and >= 0. Immutable.
struct TextureImage {
    ImageFormat format = ImageFormat::Png;
    int width = 0, height = 0;
    int channels = 1;      ///< 1: grey, also of files with R = G = B throughout; 3: R, G, B
    ImageSamples samples;  ///< [height][width][channels], row 0 on top
    PictureColour colour;  ///< what the file says of the numbers
    /// What they are by that; empty: neither, see in_file_colours().
    std::optional<ColourEncoding> encoding;
    double largest = 0;  ///< of all numbers, those of 8 and 16 bits as 0 to 1
    TexelPlace largest_at;

    [[nodiscard]] std::uint64_t memory_bytes() const;
};
/// Of numbers that a file says nothing of: linear for EXR, sRGB for PNG and JPEG, as such files
/// nearly always are.
[[nodiscard]] ColourEncoding usual_encoding(ImageFormat format);

using TextureImagePtr = std::shared_ptr<const TextureImage>;

/// Reads the bytes of a PNG, JPEG or EXR file. Error{InvalidInput}, besides those of
/// decode_image(): "bad-image": transparent somewhere (a reflectance has no transparency; alpha 1
/// is dropped), an ICC profile or chromaticities that give no colours; "out-of-range" and
/// "not-finite": a number below 0, infinite or none, with its pixel. Thread-safe.
[[nodiscard]] Result<TextureImagePtr> read_texture_image(std::string_view bytes,
                                                         std::size_t max_pixels);

}  // namespace bouguer::renderer
