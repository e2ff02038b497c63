// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/picture_file.h"

#include <algorithm>
#include <array>

#include "renderer/film/icc_profile.h"
#include "renderer/film/image_decoder.h"
#include "renderer/film/image_file.h"
#include "renderer/spectrum/display.h"

namespace bouguer::renderer {
namespace {

/// What the numbers of a file mean.
struct Meaning {
    Matrix3 to_xyz;
    TransferCurve decode{TransferCurve::Kind::Linear};
    bool is_xyz = false;  ///< the numbers are what is wanted
};

/// One of displays() with these chromaticities: then its matrix is exact.
const Display* space_with(const std::array<float, 8>& chromaticities) {
    const auto it = std::find_if(displays().begin(), displays().end(), [&](const Display& d) {
        return listed(d.chromaticities) == chromaticities;
    });
    return it == displays().end() ? nullptr : &*it;
}

/// By chromaticities, those of Rec.709 without.
Result<Meaning> meaning_of(const PictureColour& colour) {
    const auto given = colour.chromaticities.value_or(listed(find_display("srgb")->chromaticities));
    if (const Display* space = space_with(given))
        return Meaning{inverse(space->from_xyz), colour.transfer, space->name == "xyz"};
    const auto matrix = to_xyz(given);
    if (!matrix) return tl::unexpected(matrix.error());
    return Meaning{*matrix, colour.transfer};
}

Result<Meaning> meaning_of_exr(const DecodedImage& image) {
    return meaning_of({{TransferCurve::Kind::Linear}, image.colour.chromaticities, {}});
}

Result<Meaning> meaning_of_png(const DecodedImage& image) {
    if (image.colour.icc_profile.empty()) {
        auto meaning = meaning_of(image.colour);
        if (meaning) meaning->is_xyz = false;
        return meaning;
    }
    const auto is_it = [&](const Display& d) { return icc_profile(d) == image.colour.icc_profile; };
    const auto display = std::find_if(displays().begin(), displays().end(), is_it);
    if (display == displays().end())
        return fail(ErrorKind::InvalidInput,
                    "the ICC profile of the PNG file is none of Bouguer's displays; convert it to "
                    "sRGB",
                    "bad-image");
    const bool is_srgb = display->encode == &srgb_encode;
    return Meaning{inverse(display->from_xyz),
                   {is_srgb ? TransferCurve::Kind::Srgb : TransferCurve::Kind::Linear}};
}

Picture in_xyz(const DecodedImage& image, const Meaning& meaning) {
    Picture picture{image.width, image.height, {}};
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::vector<float> values = image.values();
    picture.xyz.reserve(values.size() / channels * 3);
    for (std::size_t i = 0; i < values.size(); i += channels) {
        const float* p = values.data() + i;
        const std::array<float, 3> numbers =
            channels < 3 ? std::array{p[0], p[0], p[0]} : std::array{p[0], p[1], p[2]};
        if (meaning.is_xyz) {
            picture.xyz.insert(picture.xyz.end(), numbers.begin(), numbers.end());
            continue;
        }
        std::array<double, 3> linear{};
        std::transform(numbers.begin(), numbers.end(), linear.begin(),
                       [&](float v) { return meaning.decode(v); });
        for (const double v : meaning.to_xyz* linear) picture.xyz.push_back(static_cast<float>(v));
    }
    return picture;
}

}  // namespace

Result<LoadedPicture> load_picture(std::string_view bytes, std::size_t max_pixels) {
    const auto image = decode_image(bytes, max_pixels);
    if (!image) return tl::unexpected(image.error());
    if (image->format == ImageFormat::Jpeg)
        return fail(ErrorKind::InvalidInput, "a JPEG file is no picture to measure", "bad-image");
    const bool is_png = image->format == ImageFormat::Png;
    const auto meaning = is_png ? meaning_of_png(*image) : meaning_of_exr(*image);
    if (!meaning) return tl::unexpected(meaning.error());
    return LoadedPicture{in_xyz(*image, *meaning), is_png};
}

}  // namespace bouguer::renderer
