// SPDX-License-Identifier: Apache-2.0
#include "api/material_reader.h"

#include <array>

#include "api/json_reader.h"
#include "api/nearest_name.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::api {
namespace {

using renderer::MaterialModel;
using renderer::SpectrumPtr;

constexpr Interval kExponent{0, 1e6};
constexpr Interval kRoughness{1e-4, 1};

/// A spectrum in [0, 1], or a texture of such; 1 when it is not given.
renderer::SurfaceSpectrum factor_or_one(JsonReader& reader, std::string_view key,
                                        const ColourReaders& colours) {
    const auto member = reader.find(key);
    return member ? colours.textures.factor(*member) : renderer::constant_spectrum(1);
}

SpectrumPtr index_or(JsonReader& reader, double fallback, const ColourReaders& colours) {
    const auto member = reader.find("ior");
    return member ? colours.spectra.index(*member) : renderer::constant_spectrum(fallback);
}

renderer::ComplexIndex dielectric(SpectrumPtr index) {
    return {std::move(index), renderer::constant_spectrum(0)};
}

/// At least one of the shares, or nothing would be seen.
void require_one_of(JsonReader& reader, const std::vector<std::string_view>& shares) {
    for (const std::string_view key : shares)
        if (reader.find(key)) return;
    const std::string names = quoted_list(shares);
    reader.value().report("missing", "one of " + names + " is required here",
                          names + (shares.size() == 2 ? " or both" : ", or several"));
}

std::optional<renderer::Absorption> read_absorption(JsonReader& material,
                                                    const ColourReaders& colours) {
    const auto value = material.find("absorption");
    if (!value) return std::nullopt;
    JsonReader reader(*value);
    const auto at = reader.require("transmittance");
    const SpectrumPtr transmittance = at ? colours.spectra.factor(*at) : nullptr;
    const double thickness = reader.number("thickness", kPositiveLength, 1);
    reader.reject_unknown_keys();
    if (transmittance == nullptr) return std::nullopt;
    return renderer::Absorption{transmittance, thickness};
}

/// hall: reflectance, transmittance (spectra in [0, 1], default 1), k_sr, k_st ([0, 1], default 0,
/// at least one of them given), n ([0, 1e6], default 1), ior (an index, default 1), absorption
/// {transmittance, thickness (scene units, default 1)}, mirror (default: whether k_st > 0).
MaterialModel read_hall(JsonReader& reader, const ColourReaders& colours) {
    require_one_of(reader, {"k_sr", "k_st"});
    renderer::HallMaterial hall;
    hall.reflectance = factor_or_one(reader, "reflectance", colours);
    hall.transmittance = factor_or_one(reader, "transmittance", colours);
    hall.k_sr = reader.number("k_sr", kUnit, 0);
    hall.k_st = reader.number("k_st", kUnit, 0);
    hall.n = reader.number("n", kExponent, 1);
    hall.ior = index_or(reader, 1, colours);
    hall.absorption = read_absorption(reader, colours);
    hall.mirror = reader.boolean("mirror", hall.k_st > 0);
    return hall;
}

/// diffuse, specular (spectra in [0, 1], default 1), k_d, k_s ([0, 1], default 0, at least one of
/// them given), mirror (default false).
template <class Material>
void read_matt_and_gloss(JsonReader& reader, const ColourReaders& colours, Material& material) {
    require_one_of(reader, {"k_d", "k_s"});
    material.diffuse = factor_or_one(reader, "diffuse", colours);
    material.specular = factor_or_one(reader, "specular", colours);
    material.k_d = reader.number("k_d", kUnit, material.k_d);
    material.k_s = reader.number("k_s", kUnit, material.k_s);
    material.mirror = reader.boolean("mirror", material.mirror);
}

/// phong: as read_matt_and_gloss(), and n ([0, 1e6], default 20).
MaterialModel read_phong(JsonReader& reader, const ColourReaders& colours) {
    renderer::PhongMaterial phong;
    read_matt_and_gloss(reader, colours, phong);
    phong.n = reader.number("n", kExponent, phong.n);
    return phong;
}

/// blinn: as read_matt_and_gloss(), and c3 ([1e-4, 1], default 0.35), ior (an index, default 1.5).
MaterialModel read_blinn(JsonReader& reader, const ColourReaders& colours) {
    renderer::BlinnMaterial blinn;
    read_matt_and_gloss(reader, colours, blinn);
    blinn.c3 = reader.number("c3", kRoughness, blinn.c3);
    blinn.index = dielectric(index_or(reader, 1.5, colours));
    return blinn;
}

/// One of "metal" and "ior"; what is left of the two is reported.
renderer::ComplexIndex metal_or_index(JsonReader& reader, const ColourReaders& colours) {
    const auto metal = reader.find("metal");
    const auto ior = reader.find("ior");
    if (metal && ior)
        metal->report("exclusive", "a surface is of a metal or of a dielectric",
                      "\"metal\" or \"ior\", not both");
    if (metal) return colours.spectra.metal(*metal).value_or(renderer::ComplexIndex{});
    return dielectric(index_or(reader, 1.5, colours));
}

/// cook_torrance: diffuse, specular (spectra in [0, 1], default 1), k_d (default 0), k_s (default
/// 1; together at most 1), m ([1e-4, 1], default 0.3), metal (a name, or {n, k}) or ior (an index,
/// default 1.5), mirror (default false).
MaterialModel read_cook_torrance(JsonReader& reader, const ColourReaders& colours) {
    renderer::CookTorranceMaterial surface;
    surface.diffuse = factor_or_one(reader, "diffuse", colours);
    surface.specular = factor_or_one(reader, "specular", colours);
    surface.k_d = reader.number("k_d", kUnit, surface.k_d);
    surface.k_s = reader.number("k_s", kUnit, 1 - surface.k_d);
    if (surface.k_d + surface.k_s > 1 + 1e-12)
        reader.find("k_s")->report("out-of-range", "the shares are more than the whole",
                                   "k_d + k_s at most 1");
    surface.m = reader.number("m", kRoughness, surface.m);
    surface.index = metal_or_index(reader, colours);
    surface.mirror = reader.boolean("mirror", surface.mirror);
    return surface;
}

/// hall_greenberg: diffuse, specular, transmittance (spectra in [0, 1], default 1), k_dr, k_sr,
/// k_st ([0, 1], default 0, at least one of them given), n, n_t ([0, 1e6], default 20), ior (an
/// index, default 1.5) or, where k_st is 0, metal, absorption as in hall, mirror (default: whether
/// k_sr > 0).
MaterialModel read_hall_greenberg(JsonReader& reader, const ColourReaders& colours) {
    require_one_of(reader, {"k_dr", "k_sr", "k_st"});
    renderer::HallGreenbergMaterial surface;
    surface.diffuse = factor_or_one(reader, "diffuse", colours);
    surface.specular = factor_or_one(reader, "specular", colours);
    surface.transmittance = factor_or_one(reader, "transmittance", colours);
    surface.k_dr = reader.number("k_dr", kUnit, 0);
    surface.k_sr = reader.number("k_sr", kUnit, 0);
    surface.k_st = reader.number("k_st", kUnit, 0);
    surface.n = reader.number("n", kExponent, surface.n);
    surface.n_t = reader.number("n_t", kExponent, surface.n_t);
    surface.index = metal_or_index(reader, colours);
    if (const auto metal = reader.find("metal"); metal && surface.k_st > 0)
        metal->report("exclusive", "no light goes through a metal", "k_st = 0, or \"ior\"");
    surface.absorption = read_absorption(reader, colours);
    surface.mirror = reader.boolean("mirror", surface.k_sr > 0);
    return surface;
}

struct MaterialEntry {
    std::string_view name, description;
    MaterialModel (*read)(JsonReader&, const ColourReaders&);
};

/// To add a material, write its function and its line here.
constexpr std::array kMaterials{
    MaterialEntry{"hall",
                  "The seed paper's improved Hall model: a share that is reflected and one that "
                  "goes through, a lobe (L.N)^n for lamps, absorption along the path inside.",
                  &read_hall},
    MaterialEntry{"phong",
                  "Phong 1975: Lambert's cosine and a highlight about the mirrored direction.",
                  &read_phong},
    MaterialEntry{"blinn",
                  "Blinn 1977, after Torrance and Sparrow: facets, shadowing, and Fresnel's "
                  "reflectance.",
                  &read_blinn},
    MaterialEntry{"cook_torrance",
                  "Cook and Torrance 1982: Beckmann's facets, and Fresnel's reflectance by "
                  "wavelength, which shifts the colour of a metal's highlight.",
                  &read_cook_torrance},
    MaterialEntry{"hall_greenberg",
                  "Hall and Greenberg 1983, the model that the seed improves: matt, highlight, and "
                  "rays divided by Fresnel's equations.",
                  &read_hall_greenberg},
};

}  // namespace

const std::vector<MaterialType>& material_types() {
    static const std::vector<MaterialType> types = [] {
        std::vector<MaterialType> all;
        for (const MaterialEntry& entry : kMaterials)
            all.push_back({entry.name, entry.description});
        return all;
    }();
    return types;
}

std::optional<int> read_priority(JsonReader& reader) {
    constexpr int kHighest = 1000;
    const auto at = reader.find("priority");
    const auto priority = at ? at->integer(-kHighest, kHighest) : std::nullopt;
    return priority ? std::optional(static_cast<int>(*priority)) : std::nullopt;
}

std::optional<renderer::MaterialDescription> read_material(const JsonValue& value,
                                                           const ColourReaders& colours) {
    JsonReader reader(value);
    const MaterialEntry* entry = find_type(reader, kMaterials);
    if (entry == nullptr) return std::nullopt;
    renderer::MaterialDescription material{{}, entry->read(reader, colours)};
    if (const auto at = reader.find("emission")) material.emission = colours.textures.emission(*at);
    material.priority = read_priority(reader).value_or(0);
    reader.reject_unknown_keys();
    return material;
}

}  // namespace bouguer::api
