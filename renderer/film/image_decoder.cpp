// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/image_decoder.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <string>

#include "renderer/film/image_header.h"
#include "renderer/film/image_library.h"

namespace bouguer::renderer {
namespace {

struct Format {
    ImageFormat format;
    std::string_view first_bytes;
    const char* file_name;  ///< chooses the library's reader
};
constexpr std::array kFormats{
    Format{ImageFormat::Png, "\x89PNG\r\n\x1a\n", "picture.png"},
    Format{ImageFormat::Jpeg, "\xff\xd8\xff", "picture.jpg"},
    Format{ImageFormat::Exr, "\x76\x2f\x31\x01", "picture.exr"},
};

const Format* find_format(std::string_view bytes) {
    const auto it = std::find_if(kFormats.begin(), kFormats.end(),
                                 [&](const Format& f) { return bytes.starts_with(f.first_bytes); });
    return it == kFormats.end() ? nullptr : &*it;
}

tl::unexpected<Error> refuse(const char* reason) {
    return fail(ErrorKind::InvalidInput, reason, "bad-image");
}

/// Grey or RGB, alone or with alpha behind it.
bool are_channels_known(const OIIO::ImageSpec& spec) {
    const auto& names = spec.channelnames;
    if (spec.nchannels < 1 || spec.nchannels > 4) return false;
    const bool has_alpha = spec.nchannels % 2 == 0;
    if (has_alpha && spec.alpha_channel != spec.nchannels - 1) return false;
    if (spec.nchannels < 3) return names[0] == "Y" || names[0] == "I";
    return names[0] == "R" && names[1] == "G" && names[2] == "B";
}

Result<void> check_header(const OIIO::ImageSpec& spec, std::size_t max_pixels) {
    if (spec.width <= 0 || spec.height <= 0 || spec.depth > 1) return refuse("the image is empty");
    if (auto fits = check_pixels(static_cast<std::uint64_t>(spec.width),
                                 static_cast<std::uint64_t>(spec.height), max_pixels);
        !fits) {
        return fits;
    }
    if (spec.deep) return refuse("the image has samples in depth, which are not read");
    if (spec.x != spec.full_x || spec.y != spec.full_y || spec.width != spec.full_width ||
        spec.height != spec.full_height)
        return refuse("the image's data window is not its display window");
    if (spec.get_string_attribute("jpeg:ColorSpace") == "CMYK")
        return refuse("the image is CMYK, which has no colour without a profile");
    if (!are_channels_known(spec))
        return refuse("the image's channels are neither grey nor R, G, B, with or without alpha");
    return {};
}

std::vector<std::uint8_t> icc_profile_of(const OIIO::ImageSpec& spec) {
    const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile");
    if (profile == nullptr) return {};
    const auto* bytes = static_cast<const std::uint8_t*>(profile->data());
    return {bytes, bytes + profile->type().size()};
}

/// The pixels as numbers of type T, which `type` names.
template <class T>
bool read_samples(OIIO::ImageInput& in, OIIO::TypeDesc type, DecodedImage& image) {
    std::vector<T> samples(static_cast<std::size_t>(image.width) *
                           static_cast<std::size_t>(image.height) *
                           static_cast<std::size_t>(image.channels));
    if (!in.read_image(0, 0, 0, image.channels, type, samples.data())) {
        static_cast<void>(in.geterror());
        return false;
    }
    image.samples = std::move(samples);
    return true;
}

bool read_samples(OIIO::ImageInput& in, DecodedImage& image) {
    const auto type = static_cast<OIIO::TypeDesc::BASETYPE>(in.spec().format.basetype);
    if (type == OIIO::TypeDesc::UINT8) return read_samples<std::uint8_t>(in, type, image);
    if (type == OIIO::TypeDesc::UINT16) return read_samples<std::uint16_t>(in, type, image);
    return read_samples<float>(in, OIIO::TypeDesc::FLOAT, image);
}

}  // namespace

std::optional<ImageFormat> image_format_of(std::string_view bytes) {
    const Format* found = find_format(bytes);
    return found != nullptr ? std::optional(found->format) : std::nullopt;
}

std::vector<float> DecodedImage::values() const {
    return std::visit(
        [](const auto& numbers) {
            using T = typename std::decay_t<decltype(numbers)>::value_type;
            const float one = std::is_integral_v<T> ? std::numeric_limits<T>::max() : 1;
            std::vector<float> floats(numbers.begin(), numbers.end());
            for (float& v : floats) v /= one;
            return floats;
        },
        samples);
}

Result<DecodedImage> decode_image(std::string_view bytes, std::size_t max_pixels) {
    set_up_image_library();
    const Format* format = find_format(bytes);
    if (format == nullptr) return refuse(kUnknownImageFormat);

    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
    OIIO::Filesystem::IOProxy* proxy = &memory;
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    wishes.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);  // among wishes it alone counts
    const auto in = OIIO::ImageInput::open(format->file_name, &wishes, &memory);
    if (!in) {
        static_cast<void>(OIIO::geterror());  // taken, so that it does not wait for the next caller
        return refuse(kDamagedImageHeader);
    }
    in->threads(1);
    const OIIO::ImageSpec& spec = in->spec();
    if (auto good = check_header(spec, max_pixels); !good)
        return tl::unexpected(std::move(good).error());

    DecodedImage image;
    image.format = format->format;
    image.width = spec.width;
    image.height = spec.height;
    image.channels = spec.nchannels;
    image.orientation = spec.get_int_attribute("Orientation", 1);
    if (std::array<float, 8> c{};
        spec.getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), c.data()))
        image.chromaticities = c;
    if (float y = 0; spec.getattribute("whiteLuminance", OIIO::TypeDesc::FLOAT, &y))
        image.white_luminance = y;
    image.icc_profile = icc_profile_of(spec);
    if (!read_samples(*in, image))
        return refuse("the image cannot be read: its pixels are damaged");
    return image;
}

}  // namespace bouguer::renderer
