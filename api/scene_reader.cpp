// SPDX-License-Identifier: Apache-2.0
#include "api/scene_reader.h"

#include <array>
#include <utility>
#include <vector>

#include "api/ambient_reader.h"
#include "api/asset_survey.h"
#include "api/camera_reader.h"
#include "api/light_reader.h"
#include "api/material_reader.h"
#include "api/nearest_name.h"
#include "api/object_reader.h"
#include "api/scene_warnings.h"
#include "api/spectrum_reader.h"
#include "api/texture_reader.h"
#include "renderer/scene/mend_meshes.h"

namespace bouguer::api {
namespace {

constexpr std::array kUnits{
    std::pair{std::string_view("m"), 1.0},       std::pair{std::string_view("cm"), 1e-2},
    std::pair{std::string_view("mm"), 1e-3},     std::pair{std::string_view("km"), 1e3},
    std::pair{std::string_view("um"), 1e-6},     std::pair{std::string_view("inch"), 0.0254},
    std::pair{std::string_view("foot"), 0.3048},
};

renderer::Real read_units(JsonReader& reader) {
    std::vector<std::string_view> names;
    for (const auto& [name, metres] : kUnits) names.push_back(name);
    const std::string_view units = reader.one_of("units", names, "m");
    for (const auto& [name, metres] : kUnits) {
        if (name == units) return metres;
    }
    return 1;
}

/// Every name is known afterwards, also of materials that have problems.
std::vector<renderer::MaterialDescription> read_materials(const std::optional<JsonValue>& value,
                                                          const ColourReaders& colours,
                                                          const Limits& limits, NameIndex& names) {
    std::vector<renderer::MaterialDescription> materials;
    if (!value) return materials;
    if (!value->json().is_object()) {
        value->report_type("an object of materials by name");
        return materials;
    }
    if (value->json().size() > limits.materials) {
        value->report("over-limit", "there are too many materials",
                      "at most " + std::to_string(limits.materials) + " materials");
    }
    for (const auto& [name, json] : value->json().members()) {
        names.emplace(name, materials.size());
        if (materials.size() >= limits.materials) {  // known by name only
            materials.emplace_back();
            continue;
        }
        auto material = read_material(value->member(name), colours);
        materials.push_back(std::move(material).value_or(renderer::MaterialDescription{}));
        materials.back().name = name;
    }
    return materials;
}

std::vector<renderer::LightDescription> read_lights(const std::optional<JsonValue>& value,
                                                    SpectrumReader& spectra, const Limits& limits) {
    std::vector<renderer::LightDescription> lights;
    if (!value || !value->is_array(0, limits.lights, "lights")) return lights;
    for (std::size_t i = 0; i < value->json().size(); ++i) {
        auto light = read_light(value->element(i), spectra);
        if (light) lights.push_back(*std::move(light));
    }
    return lights;
}

}  // namespace

bool read_format(JsonReader& reader, std::string_view format) {
    const auto found = reader.require("format");
    if (!found || found->json().is_text(format)) return true;
    const std::string allowed = quoted_list({format});
    if (found->json().is_string()) {
        found->report("unknown-format", "this format is not known here", allowed);
    } else {
        found->report_type(allowed);
    }
    return false;
}

renderer::SceneDescription read_scene(const JsonValue& value, const ReadContext& context,
                                      renderer::SpectrumNotes& notes) {
    const Limits& limits = context.limits;
    renderer::SceneDescription scene;
    JsonReader reader(value);
    if (!reader.is_object() || !read_format(reader, kSceneFormat)) return scene;
    survey_assets(value.json(), context);
    if (const auto name = reader.find("name")) {
        scene.name = name->text(limits.name_bytes).value_or("");
    }
    scene.metres_per_unit = read_units(reader);
    if (const auto at = reader.require("camera")) {
        const auto camera = read_camera(*at, limits).value_or(ReadCamera{});
        scene.camera = camera.camera;
        scene.resolution = camera.resolution;
    }
    SpectrumReader spectra(reader.find("spectra"), limits);
    TextureReader textures(reader.find("textures"), spectra, context);
    NameIndex material_names;
    scene.materials =
        read_materials(reader.find("materials"), {spectra, textures}, limits, material_names);
    NameIndex object_names;
    if (const auto at = reader.require("objects")) {
        scene.objects = read_objects(*at, material_names, scene.materials, context, object_names);
    }
    scene.lights = read_lights(reader.find("lights"), spectra, limits);
    if (const auto at = reader.find("environment")) {
        scene.environment = read_environment(*at, spectra);
    }
    if (const auto at = reader.find("ambient")) {
        scene.ambient = read_ambient(*at, object_names, spectra);
    }
    textures.read_all();
    spectra.read_all();
    notes = spectra.notes();
    reader.reject_unknown_keys();
    if (value.problems().empty()) renderer::mend_meshes(scene);
    if (value.problems().empty()) warn_of_scene(scene, value.pointer(), value.problems());
    return scene;
}

}  // namespace bouguer::api
