// SPDX-License-Identifier: Apache-2.0
#include "api/read_texture.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "api/asset_reader.h"
#include "api/nearest_name.h"
#include "renderer/textures/checker_texture.h"
#include "renderer/textures/file_colours.h"
#include "renderer/textures/grid_texture.h"
#include "renderer/textures/image_texture.h"

namespace bouguer::api {
namespace {

using renderer::Vec2;

constexpr Interval kRepetitions{0, 1e9, true};
constexpr Interval kShift{-1e9, 1e9};
constexpr Interval kAngle_deg{-1e6, 1e6};

std::optional<Vec2> read_pair(const JsonValue& value, const Interval& each) {
    if (!value.is_tuple(2, "numbers")) return std::nullopt;
    const auto x = value.element(0).number(each);
    const auto y = value.element(1).number(each);
    return x && y ? std::optional(Vec2{*x, *y}) : std::nullopt;
}

/// One number for both ways, or a pair.
std::optional<Vec2> read_scale(const JsonValue& value) {
    if (value.json().is_array()) return read_pair(value, kRepetitions);
    const auto both = value.number(kRepetitions);
    return both ? std::optional(Vec2{*both, *both}) : std::nullopt;
}

renderer::UvMapping read_mapping(JsonReader& reader) {
    renderer::UvMapping mapping;
    if (const auto at = reader.find("scale")) {
        mapping.scale = read_scale(*at).value_or(mapping.scale);
    }
    if (const auto at = reader.find("offset")) {
        mapping.offset = read_pair(*at, kShift).value_or(mapping.offset);
    }
    mapping.rotate_deg = reader.number("rotate_deg", kAngle_deg, 0);
    return mapping;
}

/// The value of an enumeration that `key` names by one of `names`, which are in its order.
template <class Enum, std::size_t N>
Enum choice(JsonReader& reader, std::string_view key, const std::array<std::string_view, N>& names,
            Enum fallback) {
    const auto chosen =
        reader.one_of(key, {names.begin(), names.end()}, names[static_cast<std::size_t>(fallback)]);
    return static_cast<Enum>(std::find(names.begin(), names.end(), chosen) - names.begin());
}

/// The document has the last word, and is told that it has.
void warn_of_override(const JsonValue& encoding_at, const renderer::TextureImage& image,
                      renderer::ColourEncoding encoding) {
    if (!renderer::states_encoding(image.colour, image.channels == 1) || image.encoding == encoding)
        return;
    encoding_at.warn("color-space-overrides",
                     "the image file says that its numbers mean something else",
                     "leave color_space out to have the colours that the file states");
}

/// image: path or asset, color_space (default: what the file says; without any word of it srgb for
/// PNG and JPEG, linear for EXR), filter, wrap.
std::optional<ReadTexture> read_image(JsonReader& reader, TextureKindContext& with) {
    using renderer::ColourEncoding;
    const auto mapping = read_mapping(reader);
    const auto filter =
        choice(reader, "filter", renderer::kTextureFilterNames, renderer::TextureFilter::Bilinear);
    const auto wrap =
        choice(reader, "wrap", renderer::kTextureWrapNames, renderer::TextureWrap::Repeat);
    const auto encoding_at = reader.find("color_space");
    const auto encoding =
        choice(reader, "color_space", renderer::kColourEncodingNames, ColourEncoding::Srgb);
    const auto asset = require_asset(reader, with.context.limits);
    if (!asset) return std::nullopt;

    const auto image = with.context.assets.image(asset->name);
    if (!image) {
        report_asset(*asset, image.error(), "bad-image",
                     "a PNG, JPEG or EXR file of finite numbers >= 0");
        return std::nullopt;
    }
    if (encoding_at) warn_of_override(*encoding_at, **image, encoding);
    const auto colours = encoding_at ? image : renderer::in_file_colours(*image);
    if (!colours) {
        report_asset(*asset, colours.error(), "bad-image", "colours within Rec.709");
        return std::nullopt;
    }
    const auto texture = renderer::image_texture(
        *colours, {encoding_at ? encoding : *(*colours)->encoding, filter, wrap, mapping});
    if (!texture) {
        report_asset(*asset, texture.error(), "bad-image", "numbers in [0, 1]");
        return std::nullopt;
    }
    const renderer::TexelPlace& place = (*colours)->largest_at;
    return ReadTexture{
        *texture, (*colours)->largest,
        "column " + std::to_string(place.column) + ", row " + std::to_string(place.row)};
}

/// A spectrum that textures mix; empty after a report.
std::optional<ReadSpectrum> read_part(JsonReader& reader, std::string_view key,
                                      SpectrumReader& spectra) {
    const auto at = reader.require(key);
    // emission() judges it for every use; what is accepted there is read again for its bounds.
    if (!at || spectra.emission(*at) == nullptr) return std::nullopt;
    return spectra.any(*at);
}

ReadTexture higher_of(renderer::TexturePtr texture, const ReadSpectrum& a, std::string_view a_key,
                      const ReadSpectrum& b, std::string_view b_key) {
    const bool is_a = a.high >= b.high;
    return {std::move(texture), std::max(a.high, b.high), quoted_list({is_a ? a_key : b_key})};
}

/// checker: a, b (spectra).
std::optional<ReadTexture> read_checker(JsonReader& reader, TextureKindContext& with) {
    const auto mapping = read_mapping(reader);
    const auto a = read_part(reader, "a", with.spectra);
    const auto b = read_part(reader, "b", with.spectra);
    if (!a || !b) return std::nullopt;
    return higher_of(renderer::checker_texture(a->spectrum, b->spectrum, mapping), *a, "a", *b,
                     "b");
}

/// grid: line, ground (spectra), width ([0, 1] of a repetition, default 0.1).
std::optional<ReadTexture> read_grid(JsonReader& reader, TextureKindContext& with) {
    const auto mapping = read_mapping(reader);
    const auto line = read_part(reader, "line", with.spectra);
    const auto ground = read_part(reader, "ground", with.spectra);
    const double width = reader.number("width", kUnit, 0.1);
    if (!line || !ground) return std::nullopt;
    return higher_of(renderer::grid_texture(line->spectrum, ground->spectrum, width, mapping),
                     *line, "line", *ground, "ground");
}

struct TextureKind {
    std::string_view name;
    std::optional<ReadTexture> (*read)(JsonReader&, TextureKindContext&);
};

/// To add a kind, write its function and its line here.
constexpr std::array kKinds{
    TextureKind{"image", &read_image},
    TextureKind{"checker", &read_checker},
    TextureKind{"grid", &read_grid},
};

}  // namespace

std::optional<ReadTexture> read_texture(const JsonValue& value, TextureKindContext& with) {
    JsonReader reader(value);
    const TextureKind* kind = find_type(reader, kKinds);
    if (kind == nullptr) return std::nullopt;
    auto texture = kind->read(reader, with);
    reader.reject_unknown_keys();
    return texture;
}

}  // namespace bouguer::api
