// SPDX-License-Identifier: Apache-2.0
// How different two pictures look.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/core/result.h"
#include "renderer/film/picture_file.h"

namespace bouguer::renderer {

/// CIEDE2000 of every pixel, and what it comes to.
struct PictureDifference {
    int width = 0, height = 0;
    std::vector<float> delta_e;  ///< [height][width], row 0 on top; NaN where it is not known
    std::uint64_t compared_pixels = 0;
    std::uint64_t unknown_pixels = 0;  ///< one of the two colours is not a finite number
    /// Of the pixels compared; NaN when there are none.
    double mean = 0;
    double percentile_95 = 0;  ///< the smallest value that at least 95 % do not exceed
    double maximum = 0;
    int maximum_x = 0, maximum_y = 0;  ///< the first such pixel, row by row
    double exposure = 1;               ///< of both pictures, unless they are as shown
};

/// Compares two pictures as `output` shows them: both exposed alike (where it gives no exposure, by
/// the automatic one of `a`) and adapted, in L*a*b* relative to the white of its display at Y = 1.
/// A picture that is as shown already has had both: it is taken as it is, and where only `b` is
/// not, the automatic exposure is that of `b`. Nothing is clipped: colours that no display shows
/// count in full. Black is L* = a* = b* = 0, so black and black do not differ. Error{InvalidInput}:
/// as view_of(); code "different-sizes". Thread-safe.
[[nodiscard]] Result<PictureDifference> compare_pictures(const LoadedPicture& a,
                                                         const LoadedPicture& b,
                                                         const OutputSettings& output);

/// The differences as a PNG: dark where there is none, over green to yellow at 10 and above
/// (viridis, whose lightness grows evenly), grey where it is not known. A scale with its numbers
/// stands below; a narrow picture gets a margin on the right so that it has room.
[[nodiscard]] Result<std::string> encode_difference_map(const PictureDifference& difference);

/// What the top of the map's scale stands for.
inline constexpr double kMapLargestDeltaE = 10;

}  // namespace bouguer::renderer
