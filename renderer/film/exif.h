// SPDX-License-Identifier: Apache-2.0
// What Exif says of a picture: how it is turned and, by cameras, its colours.
#pragma once

#include <string_view>

namespace bouguer::renderer {

/// What stands before Exif's data in a JPEG segment.
inline constexpr std::string_view kExifPrefix{"Exif\0\0", 6};

/// 1 to 8: what row 0 and column 0 of the stored picture are. 1, upright, where `data` says nothing
/// else: no such entry, a number that is none of the eight (0 is written for "unknown"), or no Exif
/// at all. With or without kExifPrefix. [CIPA DC-008 §4.6.4 A]
[[nodiscard]] int exif_orientation(std::string_view data);

/// Whether a camera says that it writes Adobe RGB: by the interoperability index R03, or by the
/// colour space 2 of some makers [CIPA DC-010 §5.1].
[[nodiscard]] bool is_adobe_rgb(std::string_view data);

}  // namespace bouguer::renderer
