// SPDX-License-Identifier: Apache-2.0
#include "api/light_reader.h"

#include <array>
#include <string_view>

#include "api/json_reader.h"

namespace bouguer::api {
namespace {

using renderer::LightDescription;
using renderer::SpectrumPtr;

SpectrumPtr require_emission(JsonReader& reader, std::string_view key, SpectrumReader& spectra) {
    const auto member = reader.require(key);
    return member ? spectra.emission(*member) : nullptr;
}

/// point: position, intensity (W sr^-1 nm^-1).
std::optional<LightDescription> read_point(JsonReader& reader, SpectrumReader& spectra) {
    const auto position = reader.require_vec3("position");
    const SpectrumPtr intensity = require_emission(reader, "intensity", spectra);
    if (!position || intensity == nullptr) return std::nullopt;
    return renderer::PointLight{*position, intensity};
}

/// directional: direction (where the light goes to), irradiance (W m^-2 nm^-1, on a surface that
/// faces it).
std::optional<LightDescription> read_directional(JsonReader& reader, SpectrumReader& spectra) {
    const auto at = reader.require("direction");
    const auto direction = at ? at->direction() : std::nullopt;
    const SpectrumPtr irradiance = require_emission(reader, "irradiance", spectra);
    if (!direction || irradiance == nullptr) return std::nullopt;
    return renderer::DirectionalLight{*direction, irradiance};
}

struct LightType {
    std::string_view name;
    std::optional<LightDescription> (*read)(JsonReader&, SpectrumReader&);
};

/// To add a light, write its function and its line here.
constexpr std::array kLights{
    LightType{"point", &read_point},
    LightType{"directional", &read_directional},
};

/// constant: radiance (W m^-2 sr^-1 nm^-1), the same from everywhere.
std::optional<renderer::ConstantEnvironment> read_constant(JsonReader& reader,
                                                           SpectrumReader& spectra) {
    const SpectrumPtr radiance = require_emission(reader, "radiance", spectra);
    if (radiance == nullptr) return std::nullopt;
    return renderer::ConstantEnvironment{radiance};
}

struct EnvironmentType {
    std::string_view name;
    std::optional<renderer::ConstantEnvironment> (*read)(JsonReader&, SpectrumReader&);
};

constexpr std::array kEnvironments{
    EnvironmentType{"constant", &read_constant},
};

}  // namespace

std::optional<LightDescription> read_light(const JsonValue& value, SpectrumReader& spectra) {
    JsonReader reader(value);
    const LightType* type = find_type(reader, kLights);
    if (type == nullptr) return std::nullopt;
    auto light = type->read(reader, spectra);
    reader.reject_unknown_keys();
    return light;
}

std::optional<renderer::ConstantEnvironment> read_environment(const JsonValue& value,
                                                              SpectrumReader& spectra) {
    JsonReader reader(value);
    const EnvironmentType* type = find_type(reader, kEnvironments);
    if (type == nullptr) return std::nullopt;
    auto environment = type->read(reader, spectra);
    reader.reject_unknown_keys();
    return environment;
}

}  // namespace bouguer::api
