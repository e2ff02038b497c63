// SPDX-License-Identifier: Apache-2.0
#include "renderer/textures/file_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "renderer/textures/channel_tables.h"

namespace bouguer::renderer {
namespace {

/// Pixels that are converted in one go.
constexpr std::size_t kRun = 1024;

/// Checks what came out, and keeps it.
class Keeper {
  public:
    Keeper(TextureImage& to, bool is_whole) : to_(to), is_whole_(is_whole) {
        const auto pixels =
            static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height);
        floats_.reserve(pixels * static_cast<std::size_t>(to.channels));
    }

    Result<void> add(std::span<float> pixels) {
        for (std::size_t i = 0; i < pixels.size(); i += 3)
            if (auto good = add_pixel(pixels.subspan(i, 3)); !good) return good;
        return {};
    }
    void finish() { to_.samples = std::move(floats_); }

  private:
    /// Half a step of 8 bits of a usual curve is 0.0045 x^0.6 of light x; half floats have 11 bits.
    [[nodiscard]] float rounding(float largest) const {
        return is_whole_ ? 0.005F * std::pow(std::max(largest, 0.0F), 0.6F) : 0.001F * largest;
    }

    Result<void> add_pixel(std::span<float> rgb) {
        const float largest = *std::max_element(rgb.begin(), rgb.end());
        const float most = is_whole_ ? 1 + rounding(1) : kInfinite;
        for (float& v : rgb) {
            if (!std::isfinite(v)) return refuse("not finite", "not-finite");
            if ((v < 0 && v < -rounding(largest)) || v > most)
                return refuse("outside Rec.709, of which textures are made: convert it to sRGB",
                              "bad-image");
            v = std::max(v, 0.0F);
            if (v > 1 && (is_whole_ || v < 1 + kFloatRounding)) v = 1;
        }
        return to_.channels == 1 ? add_grey(rgb) : add_colour(rgb);
    }
    Result<void> add_grey(std::span<const float> rgb) {
        const auto [low, high] = std::minmax({rgb[0], rgb[1], rgb[2]});
        if (high - low > 0.002F)
            return refuse("grey but coloured by the ICC profile: store R, G, B", "bad-image");
        keep((low + high) / 2);
        return {};
    }
    Result<void> add_colour(std::span<const float> rgb) {
        for (const float v : rgb) keep(v);
        return {};
    }
    void keep(float v) {
        if (v > to_.largest) {
            to_.largest = v;
            to_.largest_at = place();
        }
        floats_.push_back(v);
    }

    [[nodiscard]] TexelPlace place() const {
        const std::size_t pixel = floats_.size() / static_cast<std::size_t>(to_.channels);
        const auto width = static_cast<std::size_t>(to_.width);
        return {static_cast<int>(pixel % width), static_cast<int>(pixel / width)};
    }
    [[nodiscard]] tl::unexpected<Error> refuse(const char* what, const char* code) const {
        return fail(ErrorKind::InvalidInput,
                    "the image's colour at column " + std::to_string(place().column) + ", row " +
                        std::to_string(place().row) + " is " + what,
                    code);
    }

    static constexpr float kInfinite = std::numeric_limits<float>::infinity();
    static constexpr float kFloatRounding = 1e-5F;
    TextureImage& to_;
    bool is_whole_;
    std::vector<float> floats_;
};

/// The pixels of a picture, of which grey has three times the same number.
template <class T>
class Pixels {
  public:
    Pixels(const TextureImage& image, const std::vector<T>& samples)
        : samples_(samples), channels_(static_cast<std::size_t>(image.channels)) {}
    [[nodiscard]] std::size_t size() const { return samples_.size() / channels_; }
    [[nodiscard]] bool is_grey() const { return channels_ == 1; }
    [[nodiscard]] T number(std::size_t pixel, std::size_t k) const {
        return samples_[pixel * channels_ + k % channels_];
    }

  private:
    const std::vector<T>& samples_;
    std::size_t channels_;
};

/// Makes light of `count` pixels from `begin` on.
using MakeRun = std::function<void(std::size_t begin, std::size_t count, std::vector<float>& run)>;

template <class T>
MakeRun one_by_one(const Pixels<T>& pixels, const ToRec709& to_light) {
    return [&](std::size_t begin, std::size_t count, std::vector<float>& run) {
        constexpr float kOne = std::is_integral_v<T> ? std::numeric_limits<T>::max() : 1;
        for (std::size_t i = begin; i < begin + count; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                run.push_back(static_cast<float>(pixels.number(i, k)) / kOne);
        to_light(run);
    };
}

/// By tables, where the picture is larger than they are and there are any.
template <class T>
MakeRun fastest(const Pixels<T>& pixels, const ToRec709& to_light) {
    if constexpr (std::is_integral_v<T>) {
        constexpr std::size_t kLast = std::numeric_limits<T>::max();
        if (pixels.size() > 4 * kLast) {
            if (auto tables = ChannelTables::make(to_light, kLast, pixels.is_grey())) {
                return [&pixels, tables = *std::move(tables)](std::size_t begin, std::size_t count,
                                                              std::vector<float>& run) {
                    for (std::size_t i = begin; i < begin + count; ++i) {
                        const auto light =
                            tables({pixels.number(i, 0), pixels.number(i, 1), pixels.number(i, 2)});
                        run.insert(run.end(), light.begin(), light.end());
                    }
                };
            }
        }
    }
    return one_by_one(pixels, to_light);
}

template <class T>
Result<void> convert(const Pixels<T>& pixels, const ToRec709& to_light, TextureImage& to) {
    Keeper keeper(to, std::is_integral_v<T>);
    const MakeRun make_run = fastest(pixels, to_light);
    std::vector<float> run;
    for (std::size_t begin = 0; begin < pixels.size(); begin += kRun) {
        run.clear();
        make_run(begin, std::min(kRun, pixels.size() - begin), run);
        if (auto good = keeper.add(run); !good) return good;
    }
    keeper.finish();
    return {};
}

}  // namespace

std::uint64_t conversion_bytes(const TextureImage& image) {
    if (image.encoding) return 0;
    return std::visit([](const auto& s) { return s.size() * sizeof(float); }, image.samples);
}

Result<TextureImagePtr> in_file_colours(TextureImagePtr image) {
    if (image->encoding) return image;
    const auto to_light = linear_rec709(image->colour, usual_encoding(image->format),
                                        /*is_grey=*/image->channels == 1);
    if (!to_light) return tl::unexpected(to_light.error());
    auto light = std::make_shared<TextureImage>();
    light->format = image->format;
    light->width = image->width;
    light->height = image->height;
    light->channels = image->channels;
    light->encoding = ColourEncoding::Linear;
    const auto converted = std::visit(
        [&](const auto& samples) { return convert(Pixels(*image, samples), *to_light, *light); },
        image->samples);
    if (!converted) return tl::unexpected(converted.error());
    return light;
}

}  // namespace bouguer::renderer
