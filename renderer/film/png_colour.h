// SPDX-License-Identifier: Apache-2.0
// What a PNG file says that its numbers mean.
#pragma once

#include "renderer/film/picture_colour.h"
#include "renderer/film/png_file.h"

namespace bouguer::renderer {

/// Nothing where it has none of the chunks. By the first of cICP, iCCP, sRGB that is there, else by
/// gAMA and cHRM, each of which may be alone: primaries without a curve have the one of sRGB [PNG
/// 3rd ed. §11.3.2, §12.1]. Error{InvalidInput}, "bad-image", with the chunk's name: one that makes
/// no sense, also where another counts; a cICP that is not of full range and R, G, B, that tells
/// absolute luminances (PQ) or those of a screen in its room (HLG), or values that are not named
/// here; a profile of more than 16 MiB. Thread-safe.
[[nodiscard]] Result<PictureColour> png_colour(const PngFile& file);

}  // namespace bouguer::renderer
