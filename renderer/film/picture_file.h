// SPDX-License-Identifier: Apache-2.0
// Image files -> pictures in XYZ.
#pragma once

#include <string_view>

#include "renderer/core/result.h"
#include "renderer/render.h"

namespace bouguer::renderer {

struct LoadedPicture {
    Picture picture;
    /// Of a PNG: exposure and adaptation lie behind it, and Y = 1 is the display's white.
    bool is_as_shown = false;
};

/// Reads an OpenEXR file by the chromaticities in its header (Rec.709 without, as OpenEXR has it),
/// XYZ to the bit; or a PNG, of 8 or 16 bits, as one of displays() by its ICC profile, by the
/// curve and chromaticities that it states without one, or else as sRGB. Grey stands for R = G = B;
/// an alpha channel is left out. Error{InvalidInput}: as decode_image(), a profile that is none of
/// displays(), or chromaticities that span no colours. Thread-safe.
[[nodiscard]] Result<LoadedPicture> load_picture(std::string_view bytes,
                                                 std::size_t max_pixels = 100'000'000);

}  // namespace bouguer::renderer
