// SPDX-License-Identifier: Apache-2.0
// Image files in memory, beside encode_png() and encode_exr() of renderer/render.h, which
// image_file.cpp implements. The only door to OpenImageIO for pictures.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/core/result.h"
#include "renderer/render.h"

namespace bouguer::renderer {

/// The factor that takes the 99th percentile of the picture's Y to 1, so that a few glints do not
/// darken the rest. Where that percentile is 0, the largest Y becomes 1; of a black picture it
/// is 1. Pixels whose Y is not finite do not count.
[[nodiscard]] double automatic_exposure(const Picture& picture);

/// What a PNG or EXR file holds.
struct DecodedImage {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;  ///< [height][width][channels], row 0 on top; 8 and 16 bit: [0, 1]
    /// x, y of red, green, blue and white; EXR files that say so only.
    std::optional<std::array<float, 8>> chromaticities;
    std::optional<float> white_luminance;  ///< cd/m^2 of value 1; EXR files that say so only
};

/// Reads the bytes of a PNG or EXR file. Error{InvalidInput}: neither, damaged, or more than
/// `max_pixels`. Thread-safe.
[[nodiscard]] Result<DecodedImage> decode_image(std::string_view bytes,
                                                std::size_t max_pixels = 100'000'000);

/// "OpenImageIO 2.4.7": the library at run time.
[[nodiscard]] std::string image_library_version();

}  // namespace bouguer::renderer
