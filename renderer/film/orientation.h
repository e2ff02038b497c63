// SPDX-License-Identifier: Apache-2.0
// Turns pictures that are stored turned.
#pragma once

#include "renderer/film/image_decoder.h"

namespace bouguer::renderer {

/// Turns and mirrors the pixels so that `orientation` becomes 1, from 1 to 8 as Exif counts: of 6,
/// say, row 0 is the right side of the picture and column 0 its top [CIPA DC-008 §4.6.4 A]. Takes
/// the memory of a second picture meanwhile.
void turn_upright(DecodedImage& image);

}  // namespace bouguer::renderer
