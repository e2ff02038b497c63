// SPDX-License-Identifier: Apache-2.0
// The bytes of PNG, JPEG and EXR files -> numbers. The only decoder of pictures.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "renderer/core/result.h"
#include "renderer/film/picture_colour.h"

namespace bouguer::renderer {

enum class ImageFormat : std::uint8_t { Png, Jpeg, Exr };

/// Why a file is refused by its first bytes.
inline constexpr const char* kUnknownImageFormat = "neither a PNG nor a JPEG nor an EXR file";
inline constexpr const char* kDamagedImageHeader =
    "the image cannot be read: its header is damaged";
inline constexpr const char* kDamagedPixels = "the image cannot be read: its pixels are damaged";

/// Told by the first bytes; empty when it is none of them.
[[nodiscard]] std::optional<ImageFormat> image_format_of(std::string_view bytes);

/// Numbers as a file keeps them: of 8 or 16 bits (255 and 65535 stand for 1), or floats.
using ImageSamples =
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>>;

/// What an image file holds.
struct DecodedImage {
    ImageFormat format = ImageFormat::Png;
    int width = 0, height = 0;
    int channels = 0;      ///< 1 grey, 2 grey and alpha, 3 RGB, 4 RGB and alpha
    ImageSamples samples;  ///< [height][width][channels], row 0 on top; alpha not multiplied in
                           ///< but in EXR, where files have it so
    int orientation = 1;   ///< as Exif counts, 1 is upright; decode_image() gives no other
    PictureColour colour;  ///< an EXR file tells chromaticities only
    std::optional<float> white_luminance;  ///< cd/m^2 of value 1; EXR files that say so only

    /// The samples as floats, those of 8 and 16 bits in [0, 1].
    [[nodiscard]] std::vector<float> values() const;
};

/// Reads the bytes of an image file that is whole, upright as its Exif says. Error{InvalidInput}:
/// "bad-image": another format, broken off or damaged anywhere, what read_image_header(),
/// decode_jpeg() and png_colour() refuse, an EXR that is turned (its readers do not agree whether)
/// or whose data window is not the picture; "over-limit": more than `max_pixels`, which is found
/// before memory is taken for them. Thread-safe.
[[nodiscard]] Result<DecodedImage> decode_image(std::string_view bytes,
                                                std::size_t max_pixels = 100'000'000);

}  // namespace bouguer::renderer
