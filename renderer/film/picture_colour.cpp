// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/picture_colour.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "renderer/film/icc_transform.h"
#include "renderer/spectrum/chromatic_adaptation.h"
#include "renderer/spectrum/display.h"

namespace bouguer::renderer {
namespace {

/// A quarter of a step of 8 bits.
constexpr double kSame = 0.25 / 255;

tl::unexpected<Error> refuse(const char* reason) {
    return fail(ErrorKind::InvalidInput, reason, "bad-image");
}

Chromaticity white_of(const std::array<float, 8>& c) { return {c[6], c[7]}; }

TransferCurve curve_of(const PictureColour& colour, ColourEncoding unstated) {
    if (colour.transfer.kind != TransferCurve::Kind::Unstated) return colour.transfer;
    return {unstated == ColourEncoding::Linear ? TransferCurve::Kind::Linear
                                               : TransferCurve::Kind::Srgb};
}

Result<IccTransform> transform_of(const PictureColour& colour, bool is_grey) {
    auto transform = IccTransform::to_linear_rec709(colour.icc_profile);
    if (transform && transform->channels() == 1 && !is_grey)
        return refuse("the image's ICC profile is one of grey, but the image has colours");
    return transform;
}

/// Through a profile. What was grey and comes out so but for rounding is grey.
void pass(const IccTransform& transform, std::span<float> pixels) {
    const std::size_t channels = static_cast<std::size_t>(transform.channels());
    std::vector<float> numbers;
    numbers.reserve(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); i += 3)
        for (std::size_t k = 0; k < channels; ++k) numbers.push_back(pixels[i + k]);
    const std::vector<float> given(pixels.begin(), pixels.end());
    transform(numbers, pixels);
    for (std::size_t i = 0; i < pixels.size(); i += 3) {
        if (given[i] != given[i + 1] || given[i] != given[i + 2]) continue;
        const auto [low, high] = std::minmax({pixels[i], pixels[i + 1], pixels[i + 2]});
        constexpr float kRounding = 3e-4F;
        if (high - low <= kRounding)
            std::fill_n(pixels.begin() + static_cast<std::ptrdiff_t>(i), 3, (low + high) / 2);
    }
}

/// Greys and colours of all kinds.
std::vector<float> probes() {
    std::vector<float> pixels;
    for (int i = 0; i <= 32; ++i) pixels.insert(pixels.end(), 3, static_cast<float>(i) / 32);
    for (int i = 0; i < 6 * 6 * 6; ++i)
        for (const int number : {i % 6, i / 6 % 6, i / 36})
            pixels.push_back(static_cast<float>(number) / 5);
    return pixels;
}

/// Whether a profile does what `decode` does. A grey has to fit as it is seen, too.
bool does(const std::vector<float>& from, const std::vector<float>& to, double (*decode)(double)) {
    for (std::size_t i = 0; i < from.size(); ++i) {
        const double expected = decode(from[i]);
        if (!(std::abs(to[i] - expected) < kSame)) return false;
        const std::size_t pixel = i - i % 3;
        const bool is_grey = from[pixel] == from[pixel + 1] && from[pixel] == from[pixel + 2];
        if (is_grey && !(std::abs(srgb_encode(to[i]) - srgb_encode(expected)) < kSame))
            return false;
    }
    return true;
}

std::optional<ColourEncoding> encoding_by(const IccTransform& transform) {
    const std::vector<float> from = probes();
    std::vector<float> to = from;
    pass(transform, to);
    if (does(from, to, &srgb_decode)) return ColourEncoding::Srgb;
    if (does(from, to, [](double v) { return v; })) return ColourEncoding::Linear;
    return std::nullopt;
}

/// Whether the chromaticities are those of Rec.709, as far as files print them.
bool is_rec709(const std::array<float, 8>& c) {
    const auto& expected = find_display("rec709-linear")->chromaticities;
    for (std::size_t i = 0; i < 4; ++i) {
        if (!(std::abs(c[2 * i] - expected[i].x) <= 1e-3)) return false;
        if (!(std::abs(c[2 * i + 1] - expected[i].y) <= 1e-3)) return false;
    }
    return true;
}

/// To Rec.709's white and primaries.
Result<Matrix3> to_rec709(const std::array<float, 8>& c) {
    const auto matrix = to_xyz(c);
    if (!matrix) return matrix;
    const Chromaticity white = find_display("rec709-linear")->chromaticities[3];
    return xyz_to_rec709() * adaptation_matrix(Adaptation::Bradford, white_of(c), white) * *matrix;
}

}  // namespace

Result<Matrix3> to_xyz(const std::array<float, 8>& c) {
    // Twice the triangle of the primaries; that of Rec.709 has 0.22.
    constexpr double kLeastArea = 1e-3;
    const double area = (c[2] - c[0]) * (c[5] - c[1]) - (c[4] - c[0]) * (c[3] - c[1]);
    const bool is_finite =
        std::all_of(c.begin(), c.end(), [](float v) { return std::abs(v) < 10; });
    if (!is_finite || !(std::abs(area) >= kLeastArea) ||
        !can_be_white(Adaptation::Bradford, white_of(c)))
        return refuse("the image's chromaticities span no colours");
    return rgb_to_xyz({c[0], c[1]}, {c[2], c[3]}, {c[4], c[5]}, white_of(c));
}

bool states_encoding(const PictureColour& colour, bool is_grey) {
    return !colour.icc_profile.empty() || colour.transfer.kind != TransferCurve::Kind::Unstated ||
           (!is_grey && colour.chromaticities && !is_rec709(*colour.chromaticities));
}

Result<std::optional<ColourEncoding>> known_encoding(const PictureColour& colour,
                                                     ColourEncoding unstated, bool is_grey) {
    if (!colour.icc_profile.empty()) {
        const auto transform = transform_of(colour, is_grey);
        if (!transform) return tl::unexpected(transform.error());
        return encoding_by(*transform);
    }
    if (!is_grey && colour.chromaticities && !is_rec709(*colour.chromaticities)) {
        const auto matrix = to_rec709(*colour.chromaticities);
        if (!matrix) return tl::unexpected(matrix.error());
        return std::nullopt;
    }
    switch (curve_of(colour, unstated).kind) {
        case TransferCurve::Kind::Linear:
            return ColourEncoding::Linear;
        case TransferCurve::Kind::Srgb:
            return ColourEncoding::Srgb;
        default:
            return std::nullopt;
    }
}

Result<ToRec709> linear_rec709(const PictureColour& colour, ColourEncoding unstated, bool is_grey) {
    if (!colour.icc_profile.empty()) {
        auto made = transform_of(colour, is_grey);
        if (!made) return tl::unexpected(made.error());
        const auto transform = std::make_shared<const IccTransform>(*std::move(made));
        return [transform](std::span<float> pixels) { pass(*transform, pixels); };
    }
    Matrix3 matrix{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    if (!is_grey && colour.chromaticities && !is_rec709(*colour.chromaticities)) {
        const auto other = to_rec709(*colour.chromaticities);
        if (!other) return tl::unexpected(other.error());
        matrix = *other;
    }
    return [matrix, curve = curve_of(colour, unstated)](std::span<float> pixels) {
        for (std::size_t i = 0; i < pixels.size(); i += 3) {
            const auto light =
                matrix * std::array{curve(pixels[i]), curve(pixels[i + 1]), curve(pixels[i + 2])};
            for (std::size_t k = 0; k < 3; ++k) pixels[i + k] = static_cast<float>(light[k]);
        }
    };
}

}  // namespace bouguer::renderer
