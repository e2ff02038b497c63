// SPDX-License-Identifier: Apache-2.0
// What Exif says of a picture: how it is turned.
#pragma once

#include <string_view>

namespace bouguer::renderer {

/// What stands before Exif's data in a JPEG segment.
inline constexpr std::string_view kExifPrefix{"Exif\0\0", 6};

/// 1 to 8: what row 0 and column 0 of the stored picture are. 1, upright, where `data` says nothing
/// else: no such entry, a number that is none of the eight (0 is written for "unknown"), or no Exif
/// at all. With or without kExifPrefix. [CIPA DC-008 (Exif 2.32) §4.6.4 A]
[[nodiscard]] int exif_orientation(std::string_view data);

}  // namespace bouguer::renderer
