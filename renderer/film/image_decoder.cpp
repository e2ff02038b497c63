// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/image_decoder.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <string>
#include <utility>

#include "renderer/film/exif.h"
#include "renderer/film/exr_chunks.h"
#include "renderer/film/image_header.h"
#include "renderer/film/image_library.h"
#include "renderer/film/jpeg_decoder.h"
#include "renderer/film/orientation.h"
#include "renderer/film/png_colour.h"
#include "renderer/film/png_file.h"

namespace bouguer::renderer {
namespace {

using Decode = Result<DecodedImage> (*)(std::string_view bytes, const ImageHeader& header);
Result<DecodedImage> decode_png(std::string_view bytes, const ImageHeader& header);
Result<DecodedImage> decode_exr(std::string_view bytes, const ImageHeader& header);

struct Format {
    ImageFormat format;
    std::string_view first_bytes;
    Decode decode;
};
constexpr std::array kFormats{
    Format{ImageFormat::Png, "\x89PNG\r\n\x1a\n", &decode_png},
    Format{ImageFormat::Jpeg, "\xff\xd8\xff", &decode_jpeg},
    Format{ImageFormat::Exr, "\x76\x2f\x31\x01", &decode_exr},
};

const Format* find_format(std::string_view bytes) {
    const auto it = std::find_if(kFormats.begin(), kFormats.end(),
                                 [&](const Format& f) { return bytes.starts_with(f.first_bytes); });
    return it == kFormats.end() ? nullptr : &*it;
}

tl::unexpected<Error> refuse(std::string reason) {
    return fail(ErrorKind::InvalidInput, std::move(reason), "bad-image");
}

/// Bytes that somebody else holds.
class BorrowedSource final : public ByteSource {
  public:
    explicit BorrowedSource(std::string_view bytes) : bytes_(bytes) {}
    [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
    [[nodiscard]] Result<std::string> read(std::uint64_t offset, std::size_t count) const override {
        return std::string(bytes_.substr(std::min<std::uint64_t>(offset, bytes_.size()), count));
    }

  private:
    std::string_view bytes_;
};

/// Grey or RGB, alone or with alpha behind it.
bool are_channels_known(const OIIO::ImageSpec& spec) {
    const auto& names = spec.channelnames;
    if (spec.nchannels < 1 || spec.nchannels > 4) return false;
    const bool has_alpha = spec.nchannels % 2 == 0;
    if (has_alpha && spec.alpha_channel != spec.nchannels - 1) return false;
    if (spec.nchannels < 3) return names[0] == "Y" || names[0] == "I";
    return names[0] == "R" && names[1] == "G" && names[2] == "B";
}

/// What is right by its header is so by the library too.
Result<void> check_spec(const OIIO::ImageSpec& spec, const ImageHeader& header) {
    if (spec.deep || spec.depth > 1 || static_cast<std::uint64_t>(spec.width) != header.width ||
        static_cast<std::uint64_t>(spec.height) != header.height)
        return refuse(kDamagedImageHeader);
    if (spec.x != spec.full_x || spec.y != spec.full_y || spec.width != spec.full_width ||
        spec.height != spec.full_height)
        return refuse("the image's data window is not its display window");
    if (!are_channels_known(spec))
        return refuse("the image's channels are neither grey nor R, G, B, with or without alpha");
    const int orientation = spec.get_int_attribute("Orientation", 1);
    if (orientation >= 2 && orientation <= 8)
        return refuse("the image is an EXR file that is said to be turned: store it upright");
    return {};
}

/// The pixels as numbers of type T, which `type` names.
template <class T>
bool read_samples(OIIO::ImageInput& in, OIIO::TypeDesc type, DecodedImage& image) {
    std::vector<T> samples(static_cast<std::size_t>(image.width) *
                           static_cast<std::size_t>(image.height) *
                           static_cast<std::size_t>(image.channels));
    if (!in.read_image(0, 0, 0, image.channels, type, samples.data())) return false;
    image.samples = std::move(samples);
    return true;
}

bool read_samples(OIIO::ImageInput& in, DecodedImage& image) {
    const auto type = static_cast<OIIO::TypeDesc::BASETYPE>(in.spec().format.basetype);
    if (type == OIIO::TypeDesc::UINT8) return read_samples<std::uint8_t>(in, type, image);
    if (type == OIIO::TypeDesc::UINT16) return read_samples<std::uint16_t>(in, type, image);
    return read_samples<float>(in, OIIO::TypeDesc::FLOAT, image);
}

/// What the library says of a file that has no name: the first line behind it.
std::string report_of(const OIIO::ImageInput& in) {
    std::string text = in.geterror();
    if (const auto name = text.rfind("\". "); name != std::string::npos) text.erase(0, name + 3);
    text.erase(std::min(text.find('\n'), text.size()));
    for (char& c : text)
        if (c < ' ' || c > '~') c = '?';
    if (text.ends_with('.')) text.pop_back();
    return text.empty() ? text : ": " + text;
}

/// By OpenImageIO. `file_name` chooses the reader.
Result<DecodedImage> decode_by_library(std::string_view bytes, const ImageHeader& header,
                                       const char* file_name) {
    set_up_image_library();
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
    OIIO::Filesystem::IOProxy* proxy = &memory;
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    wishes.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);  // among wishes it alone counts
    const auto in = OIIO::ImageInput::open(file_name, &wishes, &memory);
    if (!in) {
        static_cast<void>(OIIO::geterror());  // taken, so that it does not wait for the next caller
        return refuse(kDamagedImageHeader);
    }
    in->threads(1);
    const OIIO::ImageSpec& spec = in->spec();
    if (auto good = check_spec(spec, header); !good) return tl::unexpected(std::move(good).error());

    DecodedImage image;
    image.format = header.format;
    image.width = spec.width;
    image.height = spec.height;
    image.channels = spec.nchannels;
    if (std::array<float, 8> c{};
        spec.getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), c.data()))
        image.colour.chromaticities = c;
    if (float y = 0; spec.getattribute("whiteLuminance", OIIO::TypeDesc::FLOAT, &y))
        image.white_luminance = y;
    if (!read_samples(*in, image)) return refuse(kDamagedPixels + report_of(*in));
    return image;
}

Result<DecodedImage> decode_exr(std::string_view bytes, const ImageHeader& header) {
    if (auto whole = check_exr_chunks(bytes); !whole)
        return tl::unexpected(std::move(whole).error());
    return decode_by_library(bytes, header, "picture.exr");
}

Result<DecodedImage> decode_png(std::string_view bytes, const ImageHeader& header) {
    const auto file = read_png_file(bytes);
    if (!file) return tl::unexpected(file.error());
    auto colour = png_colour(*file);
    if (!colour) return tl::unexpected(std::move(colour).error());
    auto image = decode_by_library(file->pixels_only, header, "picture.png");
    if (!image) return image;
    image->colour = *std::move(colour);
    if (const auto exif = file->statements.find("eXIf"); exif != file->statements.end())
        image->orientation = exif_orientation(exif->second);
    return image;
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
    const auto header = read_image_header(BorrowedSource(bytes));
    if (!header) return tl::unexpected(header.error());
    if (header->pixels() == 0) return refuse("the image is empty");
    if (auto fits = check_pixels(header->width, header->height, max_pixels); !fits)
        return tl::unexpected(std::move(fits).error());
    auto image = find_format(bytes)->decode(bytes, *header);
    if (image) turn_upright(*image);
    return image;
}

}  // namespace bouguer::renderer
