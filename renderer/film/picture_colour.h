// SPDX-License-Identifier: Apache-2.0
// What a file says that the numbers of its picture mean, and what they are by that.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "renderer/core/result.h"
#include "renderer/film/transfer_curve.h"
#include "renderer/spectrum/colour.h"

namespace bouguer::renderer {

/// What the numbers of an image mean: encoded by the curve of sRGB, or proportional to light. Both
/// have the primaries of Rec.709.
enum class ColourEncoding : std::uint8_t { Srgb, Linear };

/// What a file says of its numbers. Where it says nothing, nobody knows but by its format.
struct PictureColour {
    TransferCurve transfer;
    /// x, y of red, green, blue and white. Empty: those of Rec.709, or the profile's.
    std::optional<std::array<float, 8>> chromaticities;
    std::vector<std::uint8_t> icc_profile;  ///< empty, or it alone counts
};

/// Takes pixels of three numbers, 1 the largest of whole ones, to linear Rec.709: `count` floats
/// of `to` are read and written. Colours outside Rec.709 have components below 0 or above 1.
using ToRec709 = std::function<void(std::span<float> pixels)>;

/// The matrix that takes R, G, B of these primaries and white to XYZ. Error{InvalidInput},
/// "bad-image": they span no colours.
[[nodiscard]] Result<Matrix3> to_xyz(const std::array<float, 8>& chromaticities);

/// Whether the file has a word of what its numbers are. That primaries are those of Rec.709 is
/// none.
[[nodiscard]] bool states_encoding(const PictureColour& colour, bool is_grey);

/// What the numbers are where it is one of the two: by its words, to the digits that files have, or
/// by what the profile does, to a quarter of a step of 8 bits. `unstated`: without any word of a
/// curve. `is_grey`: primaries do not matter. Empty: neither. Error: as linear_rec709().
[[nodiscard]] Result<std::optional<ColourEncoding>> known_encoding(const PictureColour& colour,
                                                                   ColourEncoding unstated,
                                                                   bool is_grey);

/// What takes the numbers to light. White, whatever it is in the file, becomes 1, 1, 1: colours are
/// adapted by Bradford's transform, as ICC profiles do. Error{InvalidInput}, "bad-image": a profile
/// that IccTransform refuses or that does not fit R, G, B where `is_grey` is false; primaries that
/// span no colours.
[[nodiscard]] Result<ToRec709> linear_rec709(const PictureColour& colour, ColourEncoding unstated,
                                             bool is_grey);

}  // namespace bouguer::renderer
