// SPDX-License-Identifier: Apache-2.0
// A picture as light, where its file says that its numbers are neither sRGB nor linear Rec.709.
#pragma once

#include "renderer/textures/texture_image.h"

namespace bouguer::renderer {

/// Memory that in_file_colours() takes, bytes; 0 where the numbers stay as they are.
[[nodiscard]] std::uint64_t conversion_bytes(const TextureImage& image);

/// `image` itself where its encoding is known, else its numbers as linear floats of Rec.709's
/// primaries, with that encoding. White becomes 1, 1, 1, whatever white the file has.
///
/// Textures are mixed of Rec.709's primaries. A component that is below 0 or, of whole numbers,
/// above 1 by no more than the steps of the file and of its coding explain becomes 0 or 1.
/// Error{InvalidInput}: "bad-image": a colour further out, with its pixel; a profile that gives
/// greys a colour; "not-finite": likewise. Thread-safe.
[[nodiscard]] Result<TextureImagePtr> in_file_colours(TextureImagePtr image);

}  // namespace bouguer::renderer
