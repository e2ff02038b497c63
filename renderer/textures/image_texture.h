// SPDX-License-Identifier: Apache-2.0
// A picture on a surface.
#pragma once

#include <array>
#include <string_view>

#include "renderer/textures/texture.h"
#include "renderer/textures/texture_image.h"
#include "renderer/textures/uv_mapping.h"

namespace bouguer::renderer {

/// Bilinear: linear between the centres of the texels, so that a picture has no steps. Nearest: the
/// texel that the point is in.
enum class TextureFilter : std::uint8_t { Bilinear, Nearest };
/// What lies beyond the picture: itself again, its border, or itself mirrored.
enum class TextureWrap : std::uint8_t { Repeat, Clamp, Mirror };

/// In the order of the enumerations.
inline constexpr std::array<std::string_view, 2> kColourEncodingNames{"srgb", "linear"};
inline constexpr std::array<std::string_view, 2> kTextureFilterNames{"bilinear", "nearest"};
inline constexpr std::array<std::string_view, 3> kTextureWrapNames{"repeat", "clamp", "mirror"};

struct ImageTextureOptions {
    ColourEncoding encoding = ColourEncoding::Srgb;
    TextureFilter filter = TextureFilter::Bilinear;
    TextureWrap wrap = TextureWrap::Repeat;
    UvMapping mapping;
};

/// `image` fills the unit square of the texture's coordinates, its first row on top. Grey is a
/// multiple of one spectrum, the constant 1; a colour is mixed of srgb_primary_reflectances(), so
/// that filtering and the uplift to spectra commute and a colour in [0, 1] is a reflectance.
///
/// There are no smaller copies of the picture for far away (mip maps): the mean over many samples
/// of a pixel is the pixel's right value, which such copies would blur.
///
/// Error{InvalidInput}: sRGB-encoded numbers above 1, with the pixel.
[[nodiscard]] Result<TexturePtr> image_texture(TextureImagePtr image,
                                               const ImageTextureOptions& options);

}  // namespace bouguer::renderer
