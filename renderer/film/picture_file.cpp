// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/picture_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/film/icc_profile.h"
#include "renderer/film/image_decoder.h"
#include "renderer/film/image_file.h"
#include "renderer/spectrum/display.h"

namespace bouguer::renderer {
namespace {

using Decode = double (*)(double encoded);

double identity(double encoded) { return encoded; }

/// What the numbers of a file mean.
struct Meaning {
    Matrix3 to_xyz;
    Decode decode = &identity;
    bool is_xyz = false;  ///< the numbers are what is wanted
};

Matrix3 matrix_of(const std::array<float, 8>& c) {
    return rgb_to_xyz({c[0], c[1]}, {c[2], c[3]}, {c[4], c[5]}, {c[6], c[7]});
}

/// One of displays() with these chromaticities: then its matrix is exact.
const Display* space_with(const std::array<float, 8>& chromaticities) {
    const auto it = std::find_if(displays().begin(), displays().end(), [&](const Display& d) {
        return listed(d.chromaticities) == chromaticities;
    });
    return it == displays().end() ? nullptr : &*it;
}

Result<Meaning> meaning_of_exr(const DecodedImage& image) {
    const auto given = image.chromaticities.value_or(listed(find_display("srgb")->chromaticities));
    if (const Display* space = space_with(given))
        return Meaning{inverse(space->from_xyz), &identity, space->name == "xyz"};
    const Matrix3 matrix = matrix_of(given);
    for (const auto& row : matrix)
        for (const double v : row)
            if (!std::isfinite(v))
                return fail(ErrorKind::InvalidInput,
                            "the chromaticities of the OpenEXR file span no colours", "bad-image");
    return Meaning{matrix};
}

Result<Meaning> meaning_of_png(const DecodedImage& image) {
    const auto is_it = [&](const Display& d) {
        return image.icc_profile.empty() ? d.name == "srgb" : icc_profile(d) == image.icc_profile;
    };
    const auto display = std::find_if(displays().begin(), displays().end(), is_it);
    if (display == displays().end())
        return fail(ErrorKind::InvalidInput,
                    "the ICC profile of the PNG file is none of Bouguer's displays; convert it to "
                    "sRGB",
                    "bad-image");
    const Decode decode = display->encode == &srgb_encode ? &srgb_decode : &identity;
    return Meaning{inverse(display->from_xyz), decode, false};
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
