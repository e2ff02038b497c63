// SPDX-License-Identifier: Apache-2.0
#include "api/material_reader.h"

#include <array>
#include <string_view>

#include "api/json_reader.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::api {
namespace {

using renderer::MaterialModel;
using renderer::SpectrumPtr;

constexpr Interval kExponent{0, 1e6};
constexpr Interval kIor{1, 10};

/// A spectrum in [0, 1]; 1 when it is not given.
SpectrumPtr factor_or_one(JsonReader& reader, std::string_view key, SpectrumReader& spectra) {
    const auto member = reader.find(key);
    return member ? spectra.factor(*member) : renderer::constant_spectrum(1);
}

std::optional<renderer::Absorption> read_absorption(const JsonValue& value,
                                                    SpectrumReader& spectra) {
    JsonReader reader(value);
    const auto at = reader.require("transmittance");
    const SpectrumPtr transmittance = at ? spectra.factor(*at) : nullptr;
    const double thickness = reader.number("thickness", kPositiveLength, 1);
    reader.reject_unknown_keys();
    if (transmittance == nullptr) return std::nullopt;
    return renderer::Absorption{transmittance, thickness};
}

/// hall: reflectance, transmittance (spectra in [0, 1], default 1), k_sr, k_st ([0, 1], default 0,
/// at least one of them given), n ([0, 1e6], default 1), ior ([1, 10], default 1), absorption
/// {transmittance, thickness (scene units, default 1)}, mirror (default: whether k_st > 0).
std::optional<MaterialModel> read_hall(JsonReader& reader, SpectrumReader& spectra) {
    renderer::HallMaterial hall;
    hall.reflectance = factor_or_one(reader, "reflectance", spectra);
    hall.transmittance = factor_or_one(reader, "transmittance", spectra);
    const bool has_share = reader.find("k_sr") || reader.find("k_st");
    if (!has_share) {
        reader.value().report("missing", "one of \"k_sr\" and \"k_st\" is required here",
                              "\"k_sr\", \"k_st\" or both");
    }
    hall.k_sr = reader.number("k_sr", kUnit, 0);
    hall.k_st = reader.number("k_st", kUnit, 0);
    hall.n = reader.number("n", kExponent, 1);
    hall.ior = reader.number("ior", kIor, 1);
    if (const auto absorption = reader.find("absorption")) {
        hall.absorption = read_absorption(*absorption, spectra);
    }
    hall.mirror = reader.boolean("mirror", hall.k_st > 0);
    return hall;
}

struct MaterialType {
    std::string_view name;
    std::optional<MaterialModel> (*read)(JsonReader&, SpectrumReader&);
};

/// To add a material, write its function and its line here.
constexpr std::array kMaterials{
    MaterialType{"hall", &read_hall},
};

}  // namespace

std::optional<MaterialModel> read_material(const JsonValue& value, SpectrumReader& spectra) {
    JsonReader reader(value);
    const MaterialType* type = find_type(reader, kMaterials);
    if (type == nullptr) return std::nullopt;
    auto material = type->read(reader, spectra);
    reader.reject_unknown_keys();
    return material;
}

}  // namespace bouguer::api
