// SPDX-License-Identifier: Apache-2.0
// Pictures as image files in memory, beside encode_png() and encode_exr() of renderer/render.h,
// which image_file.cpp implements. Reading them: image_decoder.h.
#pragma once

#include <array>
#include <string>

#include "renderer/film/raster.h"
#include "renderer/render.h"

namespace bouguer::renderer {

/// The factor that takes the 99th percentile of the picture's Y to 1, so that a few glints do not
/// darken the rest. Where that percentile is 0, the largest Y becomes 1; of a black picture it
/// is 1. Pixels whose Y is not finite do not count.
[[nodiscard]] double automatic_exposure(const Picture& picture);

/// Primaries and white, x and y each, as the attribute of an EXR file lists them.
[[nodiscard]] std::array<float, 8> listed(const std::array<Chromaticity, 4>& chromaticities);

/// The bytes of a PNG file of what was drawn, sRGB.
[[nodiscard]] Result<std::string> encode_png(const Raster& raster);

}  // namespace bouguer::renderer
