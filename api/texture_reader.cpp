// SPDX-License-Identifier: Apache-2.0
#include "api/texture_reader.h"

#include "api/nearest_name.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::api {
namespace {

using renderer::SurfaceSpectrum;

/// Whether a value of a material names a texture.
bool is_textured(const JsonValue& value) {
    return value.json().is_object() && value.json().contains("texture");
}

/// Whether the texture fits where a factor is wanted; reports it at `name` when it does not.
bool is_factor(const JsonValue& name, const ReadTexture& texture) {
    if (texture.high <= 1) return true;
    name.problems().add({name.pointer(), "out-of-range", "the texture leaves the allowed range",
                         "values up to " + number_text(texture.high) + " at " + texture.high_at,
                         "values in " + kUnit.text()});
    return false;
}

}  // namespace

TextureReader::TextureReader(std::optional<JsonValue> definitions, SpectrumReader& spectra,
                             const ReadContext& context)
    : kinds_{spectra, context} {
    if (!definitions) return;
    if (!definitions->json().is_object()) {
        definitions->report_type("an object of textures by name");
        return;
    }
    // Too many are known by name only: nobody reads them.
    const std::size_t most = context.limits.textures;
    const bool is_over = definitions->json().size() > most;
    if (is_over) {
        definitions->report("over-limit", "there are too many textures",
                            "at most " + std::to_string(most) + " textures");
    }
    for (const auto& [name, json] : definitions->json().members()) {
        definitions_.emplace(name, Definition{definitions->member(name), is_over, {}});
    }
}

SurfaceSpectrum TextureReader::factor(const JsonValue& value) {
    return is_textured(value) ? product(value, true) : kinds_.spectra.factor(value);
}

SurfaceSpectrum TextureReader::emission(const JsonValue& value) {
    return is_textured(value) ? product(value, false) : kinds_.spectra.emission(value);
}

SurfaceSpectrum TextureReader::product(const JsonValue& value, bool wants_factor) {
    JsonReader reader(value);
    const auto name = reader.require("texture");
    const auto times = reader.find("times");
    reader.reject_unknown_keys();
    SurfaceSpectrum surface(renderer::constant_spectrum(1));
    if (times) {
        surface.spectrum =
            wants_factor ? kinds_.spectra.factor(*times) : kinds_.spectra.emission(*times);
    }
    Definition* definition = named(*name);
    const auto& texture = definition != nullptr ? read(*definition) : std::nullopt;
    if (!texture || (wants_factor && !is_factor(*name, *texture))) return {};
    surface.texture = texture->texture;
    return surface;
}

TextureReader::Definition* TextureReader::named(const JsonValue& name) {
    if (!name.json().is_string()) {
        name.report_type("the name of a texture");
        return nullptr;
    }
    const std::string_view text = name.json().text();
    if (const auto it = definitions_.find(text); it != definitions_.end()) return &it->second;
    std::vector<std::string_view> known;
    for (const auto& [defined, definition] : definitions_) known.push_back(defined);
    name.report("unknown-name",
                "there is no texture of this name." +
                    (name.problems().is_full() ? "" : did_you_mean(text, known)),
                known.empty() ? "none: the scene has no textures" : "one of " + quoted_list(known));
    return nullptr;
}

const std::optional<ReadTexture>& TextureReader::read(Definition& definition) {
    if (!definition.is_read) definition.texture = read_texture(definition.value, kinds_);
    definition.is_read = true;
    return definition.texture;
}

void TextureReader::read_all() {
    for (auto& [name, definition] : definitions_) {
        if (!definition.is_read) {
            definition.value.warn("unused-texture", "no material has this texture",
                                  "remove it, or give it to a material");
        }
        static_cast<void>(read(definition));
    }
}

}  // namespace bouguer::api
