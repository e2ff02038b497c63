// SPDX-License-Identifier: Apache-2.0
// The bytes of JPEG files -> numbers, by libjpeg itself: it calls a file that breaks off or whose
// data make no sense a warning, goes on with grey, and OpenImageIO hands no warning on.
#pragma once

#include <string_view>

#include "renderer/film/image_decoder.h"
#include "renderer/film/image_header.h"

namespace bouguer::renderer {

/// Grey or RGB of 8 bits, with the orientation that the file states and its ICC profile, or Adobe
/// RGB where a camera says so without one; the pixels as they are stored. Whatever libjpeg has a
/// word about is refused, and so are missing scans, more than 100 of them and a file without its
/// end. Error{InvalidInput}, "bad-image": says what is wrong and at which byte. Thread-safe. [ITU
/// T.81; libjpeg.txt]
[[nodiscard]] Result<DecodedImage> decode_jpeg(std::string_view bytes, const ImageHeader& header);

}  // namespace bouguer::renderer
