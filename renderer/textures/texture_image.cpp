// SPDX-License-Identifier: Apache-2.0
#include "renderer/textures/texture_image.h"

#include <cmath>
#include <limits>
#include <string>

namespace bouguer::renderer {
namespace {

tl::unexpected<Error> refuse(std::string reason, const char* code = "bad-image") {
    return fail(ErrorKind::InvalidInput, std::move(reason), code);
}

template <class T>
constexpr T one_of() {
    return std::is_integral_v<T> ? std::numeric_limits<T>::max() : T{1};
}

std::string at_pixel(const TexelPlace& place) {
    return " at column " + std::to_string(place.column) + ", row " + std::to_string(place.row);
}

/// Runs over the pixels of a picture and keeps what a texture needs of them.
template <class T>
class Sieve {
  public:
    Sieve(const DecodedImage& from, TextureImage& to)
        : channels_(static_cast<std::size_t>(from.channels)),
          colours_(from.channels >= 3 ? 3 : 1),
          to_(to) {}

    Result<void> run(std::vector<T> samples) {
        const std::size_t pixels = samples.size() / channels_;
        bool is_grey = true;
        for (std::size_t i = 0; i < pixels; ++i) {
            const T* p = samples.data() + i * channels_;
            if (auto good = check(p, i); !good) return good;
            is_grey = is_grey && (colours_ == 1 || (p[0] == p[1] && p[1] == p[2]));
        }
        to_.channels = is_grey ? 1 : 3;
        to_.samples = thinned(std::move(samples), is_grey ? 1 : 3);
        return {};
    }

  private:
    [[nodiscard]] TexelPlace place(std::size_t pixel) const {
        const auto width = static_cast<std::size_t>(to_.width);
        return {static_cast<int>(pixel % width), static_cast<int>(pixel / width)};
    }

    Result<void> check(const T* p, std::size_t pixel) {
        if (colours_ < channels_ && p[colours_] != one_of<T>())
            return refuse("the image is transparent" + at_pixel(place(pixel)) +
                          ": a texture has no transparency");
        for (std::size_t k = 0; k < colours_; ++k) {
            const double value = static_cast<double>(p[k]) / one_of<T>();
            if (!std::isfinite(value))
                return refuse("the image is not finite" + at_pixel(place(pixel)), "not-finite");
            if (value < 0)
                return refuse("the image is negative" + at_pixel(place(pixel)), "out-of-range");
            if (value <= to_.largest) continue;
            to_.largest = value;
            to_.largest_at = place(pixel);
        }
        return {};
    }

    /// The first `kept` numbers of every pixel, in memory of just that size.
    [[nodiscard]] std::vector<T> thinned(std::vector<T> samples, std::size_t kept) const {
        if (kept == channels_) return samples;
        std::vector<T> thin;
        thin.reserve(samples.size() / channels_ * kept);
        for (std::size_t i = 0; i < samples.size(); i += channels_)
            for (std::size_t k = 0; k < kept; ++k) thin.push_back(samples[i + k]);
        return thin;
    }

    const std::size_t channels_, colours_;
    TextureImage& to_;
};

}  // namespace

ColourEncoding usual_encoding(ImageFormat format) {
    return format == ImageFormat::Exr ? ColourEncoding::Linear : ColourEncoding::Srgb;
}

std::uint64_t TextureImage::memory_bytes() const {
    return std::visit([](const auto& s) { return s.size() * sizeof(s[0]); }, samples);
}

Result<TextureImagePtr> read_texture_image(std::string_view bytes, std::size_t max_pixels) {
    auto decoded = decode_image(bytes, max_pixels);
    if (!decoded) return tl::unexpected(std::move(decoded).error());
    auto image = std::make_shared<TextureImage>();
    image->format = decoded->format;
    image->width = decoded->width;
    image->height = decoded->height;
    image->colour = std::move(decoded->colour);
    auto sieved = std::visit(
        [&](auto& samples) {
            using T = typename std::decay_t<decltype(samples)>::value_type;
            return Sieve<T>(*decoded, *image).run(std::move(samples));
        },
        decoded->samples);
    if (!sieved) return tl::unexpected(std::move(sieved).error());
    const auto encoding =
        known_encoding(image->colour, usual_encoding(image->format), image->channels == 1);
    if (!encoding) return tl::unexpected(encoding.error());
    image->encoding = *encoding;
    return image;
}

}  // namespace bouguer::renderer
