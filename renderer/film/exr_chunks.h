// SPDX-License-Identifier: Apache-2.0
// The chunks of an OpenEXR file, before anything is made of its pixels.
#pragma once

#include <string_view>

#include "renderer/core/result.h"

namespace bouguer::renderer {

/// Looks whether every chunk of the picture is there and unfolds to as many bytes as it has to:
/// where one unfolds to fewer, OpenEXR shows for the rest what memory held before. The bytes of
/// compressions without a plain count (PIZ, B44, DWA) are left to the library. `bytes` is a file
/// whose header read_image_header() found good. Error{InvalidInput}, "bad-image", with the chunk's
/// number and byte: one that is missing, cut off, at the wrong place or damaged. Thread-safe.
/// [OpenEXR file layout]
[[nodiscard]] Result<void> check_exr_chunks(std::string_view bytes);

}  // namespace bouguer::renderer
