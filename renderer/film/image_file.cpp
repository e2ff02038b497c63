// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "renderer/film/icc_profile.h"
#include "renderer/film/image_library.h"
#include "renderer/film/view.h"
#include "renderer/spectrum/colour.h"
#include "renderer/spectrum/display.h"

namespace bouguer::renderer {
namespace {

Xyz pixel(const Picture& picture, std::size_t i) {
    const float* p = picture.xyz.data() + 3 * i;
    return {p[0], p[1], p[2]};
}

std::size_t num_pixels(const Picture& picture) { return picture.xyz.size() / 3; }

Result<void> check_size(const Picture& picture) {
    if (picture.width > 0 && picture.height > 0 &&
        picture.xyz.size() ==
            3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height))
        return {};
    return fail(ErrorKind::Internal, "the picture's size and its number of values do not agree");
}

/// `values` as the file that `spec` describes; `format` is "png" or "exr".
Result<std::string> write(const std::string& format, const OIIO::ImageSpec& spec,
                          const void* values) {
    set_up_image_library();
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::string name = "picture." + format;
    const auto out = OIIO::ImageOutput::create(name);
    if (!out) return fail(ErrorKind::Internal, "cannot write " + format + ": " + OIIO::geterror());
    out->threads(1);
    if (!out->set_ioproxy(&memory) || !out->open(name, spec) ||
        !out->write_image(spec.format, values) || !out->close())
        return fail(ErrorKind::Internal, "cannot write " + format + ": " + out->geterror());
    return std::string(bytes.begin(), bytes.end());
}

OIIO::ImageSpec spec_of(int width, int height, OIIO::TypeDesc type) {
    OIIO::ImageSpec spec(width, height, 3, type);
    spec.attribute("Software", "Bouguer");
    return spec;
}

std::uint8_t to_byte(double encoded) { return static_cast<std::uint8_t>(encoded * 255 + 0.5); }

/// The display that has the primaries; its transfer curve is not used.
const Display& space_of(FileColour colour) {
    if (colour == FileColour::Rec709) return *find_display("rec709-linear");
    return *find_display(kFileColourNames[static_cast<std::size_t>(colour)]);
}

}  // namespace

std::array<float, 8> listed(const std::array<Chromaticity, 4>& chromaticities) {
    std::array<float, 8> list{};
    for (std::size_t i = 0; i < 4; ++i) {
        list[2 * i] = static_cast<float>(chromaticities[i].x);
        list[2 * i + 1] = static_cast<float>(chromaticities[i].y);
    }
    return list;
}

double automatic_exposure(const Picture& picture) {
    std::vector<float> luminances;
    luminances.reserve(num_pixels(picture));
    for (std::size_t i = 1; i < picture.xyz.size(); i += 3)
        if (std::isfinite(picture.xyz[i])) luminances.push_back(picture.xyz[i]);
    if (luminances.empty()) return 1;
    // The smallest value that at least 99 % of the pixels do not exceed.
    const std::size_t rank = (luminances.size() * 99 + 99) / 100 - 1;
    const auto percentile = luminances.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(luminances.begin(), percentile, luminances.end());
    double reference = *percentile;
    if (reference <= 0) reference = *std::max_element(percentile, luminances.end());
    return reference > 0 ? 1 / reference : 1;
}

Result<std::string> encode_png(const Picture& picture, const OutputSettings& output,
                               ImageInfo* info) {
    if (const auto ok = check_size(picture); !ok) return tl::unexpected(ok.error());
    const auto view = view_of(picture, output);
    if (!view) return tl::unexpected(view.error());
    const Display& display = *view->display;

    ImageInfo seen;
    seen.exposure = view->exposure;
    std::vector<std::uint8_t> bytes(picture.xyz.size());
    for (std::size_t i = 0; i < num_pixels(picture); ++i) {
        const ShownColour shown = display.show((*view)(&picture.xyz[3 * i]), output.gamut);
        std::transform(shown.rgb.begin(), shown.rgb.end(),
                       bytes.begin() + static_cast<std::ptrdiff_t>(3 * i), to_byte);
        seen.out_of_gamut_pixels += shown.out_of_gamut ? 1 : 0;
        seen.over_range_pixels += shown.over_range ? 1 : 0;
        seen.clipped_pixels += shown.out_of_gamut || shown.over_range ? 1 : 0;
    }
    if (info) *info = seen;

    OIIO::ImageSpec spec = spec_of(picture.width, picture.height, OIIO::TypeDesc::UINT8);
    // Only sRGB has a chunk of its own; for the others a profile says what the numbers mean.
    if (display.name == "srgb") {
        spec.attribute("oiio:ColorSpace", "sRGB");
    } else {
        const std::vector<std::uint8_t> profile = icc_profile(display);
        spec.attribute("ICCProfile",
                       OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(profile.size())),
                       profile.data());
    }
    return write("png", spec, bytes.data());
}

Result<std::string> encode_png(const Raster& raster) {
    OIIO::ImageSpec spec = spec_of(raster.width, raster.height, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    return write("png", spec, raster.rgb.data());
}

Result<std::string> encode_exr(const Picture& picture, const OutputSettings& output) {
    if (const auto ok = check_size(picture); !ok) return tl::unexpected(ok.error());
    const Display& space = space_of(output.exr_colour);
    std::vector<float> values = picture.xyz;  // kept to the bit where XYZ is asked for
    if (output.exr_colour != FileColour::Xyz) {
        for (std::size_t i = 0; i < num_pixels(picture); ++i) {
            const Xyz c = pixel(picture, i);
            const auto rgb = space.from_xyz * std::array{c.x, c.y, c.z};
            for (std::size_t k = 0; k < 3; ++k) values[3 * i + k] = static_cast<float>(rgb[k]);
        }
    }

    OIIO::ImageSpec spec = spec_of(picture.width, picture.height, OIIO::TypeDesc::FLOAT);
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", "");  // or the time of writing goes in, and no two files are equal
    spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8),
                   listed(space.chromaticities).data());
    spec.attribute("whiteLuminance",
                   static_cast<float>(kMaxLuminousEfficacy_lm_per_W * kYIntegral_nm));
    return write("exr", spec, values.data());
}

}  // namespace bouguer::renderer
