// SPDX-License-Identifier: Apache-2.0
// What a PNG file says that its numbers mean.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/film/png_file.h"
#include "renderer/film/transfer_curve.h"

namespace bouguer::renderer {

/// Where the file says nothing, it is sRGB.
struct PngColour {
    TransferCurve transfer;
    /// x, y of red, green, blue and white. Empty: those of Rec.709, or the profile's.
    std::optional<std::array<float, 8>> chromaticities;
    std::vector<std::uint8_t> icc_profile;  ///< empty, or it alone counts
};

/// By the first of cICP, iCCP, sRGB that is there, else by gAMA and cHRM, each of which may be
/// alone: primaries without a curve have the one of sRGB [PNG 3rd ed. §11.3.2, §12.1].
/// Error{InvalidInput}, "bad-image", with the chunk's name: one that makes no sense, also where
/// another counts; a cICP that is not of full range and R, G, B, that tells absolute luminances
/// (PQ) or those of a screen in its room (HLG), or values that are not named here; a profile of
/// more than 16 MiB. Thread-safe.
[[nodiscard]] Result<PngColour> png_colour(const PngFile& file);

}  // namespace bouguer::renderer
