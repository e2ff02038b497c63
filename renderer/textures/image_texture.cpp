// SPDX-License-Identifier: Apache-2.0
#include "renderer/textures/image_texture.h"

#include <algorithm>
#include <limits>
#include <string>

#include "renderer/spectrum/display.h"
#include "renderer/spectrum/primary_reflectances.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

/// What every number of T stands for, in linear light.
template <class T>
const std::vector<float>& decoding_table(ColourEncoding encoding) {
    static const auto make = [](double (*decode)(double)) {
        constexpr std::size_t kLast = std::numeric_limits<T>::max();
        std::vector<float> table(kLast + 1);
        for (std::size_t i = 0; i <= kLast; ++i)
            table[i] = static_cast<float>(decode(static_cast<double>(i) / kLast));
        return table;
    };
    static const std::vector<float> srgb = make(srgb_decode);
    static const std::vector<float> linear = make([](double v) { return v; });
    return encoding == ColourEncoding::Srgb ? srgb : linear;
}

/// Numbers of a file as linear light.
template <class T>
class Decoder {
  public:
    explicit Decoder(ColourEncoding encoding) : table_(decoding_table<T>(encoding)) {}
    [[nodiscard]] double operator()(T number) const { return table_[number]; }

  private:
    const std::vector<float>& table_;
};
template <>
class Decoder<float> {
  public:
    explicit Decoder(ColourEncoding encoding) : is_srgb_(encoding == ColourEncoding::Srgb) {}
    [[nodiscard]] double operator()(float number) const {
        return is_srgb_ ? srgb_decode(number) : number;
    }

  private:
    bool is_srgb_;
};

/// Where `x`, in texture coordinates, falls in a picture that is put beyond its border by `wrap`:
/// in [0, 1].
Real wrapped(Real x, TextureWrap wrap) {
    switch (wrap) {
        case TextureWrap::Repeat:
            return fraction(x);
        case TextureWrap::Clamp:
            return std::clamp<Real>(x, 0, 1);
        case TextureWrap::Mirror:
            return 1 - std::abs(1 - 2 * fraction(x / 2));
    }
    return x;
}

/// Two neighbouring texels of a row or column and how much the second counts.
struct Neighbours {
    int first = 0, second = 0;
    Real share = 0;
};

/// Around `x` in [0, 1] among `size` texels. Beyond the border stands the other border when the
/// picture repeats, and the border itself when it is clamped or mirrored.
Neighbours neighbours(Real x, int size, const ImageTextureOptions& options) {
    if (options.filter == TextureFilter::Nearest) {
        const int i = std::min(static_cast<int>(x * size), size - 1);
        return {i, i, 0};
    }
    const Real place = x * size - 0.5;
    const Real below = std::floor(place);
    int first = static_cast<int>(below), second = first + 1;
    const bool repeats = options.wrap == TextureWrap::Repeat;
    if (first < 0) first = repeats ? size - 1 : 0;
    if (second >= size) second = repeats ? 0 : size - 1;
    return {first, second, place - below};
}

class ImageTexture final : public Texture {
  public:
    ImageTexture(TextureImagePtr image, const ImageTextureOptions& options)
        : image_(std::move(image)), options_(options), to_texture_(options.mapping) {
        if (image_->channels == 1) {
            spectra_ = {constant_spectrum(1)};
        } else {
            const auto& primaries = srgb_primary_reflectances();
            spectra_.assign(primaries.begin(), primaries.end());
        }
        mean_ =
            std::visit([this](const auto& samples) { return mean_of(samples); }, image_->samples);
    }

    [[nodiscard]] const std::vector<SpectrumPtr>& spectra() const override { return spectra_; }
    [[nodiscard]] TextureWeights at(Vec2 uv) const override {
        const Vec2 st = to_texture_(uv);
        const Neighbours x = neighbours(wrapped(st.x, options_.wrap), image_->width, options_);
        // rows count from the top
        const Neighbours y = neighbours(1 - wrapped(st.y, options_.wrap), image_->height, options_);
        return std::visit([&](const auto& samples) { return mixed(samples, x, y); },
                          image_->samples);
    }
    [[nodiscard]] TextureWeights mean() const override { return mean_; }
    [[nodiscard]] std::uint64_t memory_bytes() const override { return image_->memory_bytes(); }

  private:
    template <class T>
    [[nodiscard]] TextureWeights mixed(const std::vector<T>& samples, Neighbours x,
                                       Neighbours y) const {
        const Decoder<T> decode(options_.encoding);
        const auto channels = static_cast<std::size_t>(image_->channels);
        const auto texel = [&](int column, int row) {
            const auto width = static_cast<std::size_t>(image_->width);
            return samples.data() +
                   (static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)) *
                       channels;
        };
        const T* above[2] = {texel(x.first, y.first), texel(x.second, y.first)};
        const T* below[2] = {texel(x.first, y.second), texel(x.second, y.second)};
        TextureWeights weights{};
        for (std::size_t k = 0; k < channels; ++k) {
            const double top = std::lerp(decode(above[0][k]), decode(above[1][k]), x.share);
            const double bottom = std::lerp(decode(below[0][k]), decode(below[1][k]), x.share);
            weights[k] = static_cast<float>(std::lerp(top, bottom, y.share));
        }
        return weights;
    }

    /// The mean of the texels is the mean of the picture, filtered or not, for every wrap.
    template <class T>
    [[nodiscard]] TextureWeights mean_of(const std::vector<T>& samples) const {
        const Decoder<T> decode(options_.encoding);
        const auto channels = static_cast<std::size_t>(image_->channels);
        std::array<double, kMaxTextureSpectra> sums{};
        for (std::size_t i = 0; i < samples.size(); i += channels)
            for (std::size_t k = 0; k < channels; ++k) sums[k] += decode(samples[i + k]);
        TextureWeights mean{};
        const double pixels = static_cast<double>(samples.size() / channels);
        for (std::size_t k = 0; k < channels; ++k) mean[k] = static_cast<float>(sums[k] / pixels);
        return mean;
    }

    TextureImagePtr image_;
    ImageTextureOptions options_;
    UvToTexture to_texture_;
    std::vector<SpectrumPtr> spectra_;
    TextureWeights mean_{};
};

}  // namespace

Result<TexturePtr> image_texture(TextureImagePtr image, const ImageTextureOptions& options) {
    if (options.encoding == ColourEncoding::Srgb && image->largest > 1) {
        return fail(ErrorKind::InvalidInput,
                    "an sRGB-encoded number is above 1 at column " +
                        std::to_string(image->largest_at.column) + ", row " +
                        std::to_string(image->largest_at.row),
                    "out-of-range");
    }
    return std::make_shared<ImageTexture>(std::move(image), options);
}

}  // namespace bouguer::renderer
