// SPDX-License-Identifier: Apache-2.0
#include "api/light_warnings.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <variant>

#include "api/json_value.h"
#include "renderer/spectrum/colour.h"

namespace bouguer::api {
namespace {

using renderer::LightDescription;
using renderer::MaterialDescription;
using renderer::ObjectDescription;
using renderer::PointLight;
using renderer::Real;
using renderer::SceneDescription;
using renderer::Spectrum;
using renderer::Vec3;

/// Rounding of weights that are meant to be the whole.
constexpr Real kSlack = 1e-6;

const Spectrum& spectrum_of(const LightDescription& light) {
    if (const auto* point = std::get_if<PointLight>(&light)) return *point->intensity;
    return *std::get<renderer::DirectionalLight>(light).irradiance;
}

bool is_black(const Spectrum& s) {
    for (double nm = renderer::kLambdaMin_nm; nm <= renderer::kLambdaMax_nm; ++nm)
        if (s.tent_mean(nm, 1) > 0) return false;
    return true;
}

bool shines(const MaterialDescription& material) {
    const auto parts = material.emission.spectrum ? material.emission.parts()
                                                  : std::vector<renderer::SpectrumPtr>{};
    return std::any_of(parts.begin(), parts.end(), [](const auto& s) { return !is_black(*s); });
}

bool anything_shines(const SceneDescription& scene) {
    std::set<std::size_t> used;
    for (const ObjectDescription& object : scene.objects) used.insert(object.material);
    return std::any_of(used.begin(), used.end(),
                       [&](std::size_t material) { return shines(scene.materials[material]); });
}

Vec3 from_of(const SceneDescription& scene) {
    return std::visit([](const auto& camera) { return camera.from; }, scene.camera);
}
Vec3 target_of(const SceneDescription& scene) {
    return std::visit([](const auto& camera) { return camera.at; }, scene.camera);
}

/// The opaque place that shuts in a lamp and not the camera; null when there is none. Not looked
/// for where there is too much to compare.
const Place* shell_of(const SceneDescription& scene, const std::vector<Place>& places, Vec3 lamp) {
    constexpr std::size_t kMostPairs = 20'000'000;
    if (places.size() * scene.lights.size() > kMostPairs) return nullptr;
    const auto found = std::find_if(places.begin(), places.end(), [&](const Place& place) {
        const auto& material = scene.materials[scene.objects[place.object].material];
        return is_around(place, lamp) && !place.shape->contains(from_of(scene)) &&
               !renderer::needs_of(material).transmits;
    });
    return found != places.end() ? &*found : nullptr;
}

void warn_of_lamp(const SceneDescription& scene, const std::vector<Place>& places, std::size_t i,
                  WarningSink& sink) {
    const std::string at = "/lights/" + std::to_string(i);
    if (is_black(spectrum_of(scene.lights[i]))) {
        sink.warn(at, "lamp-without-light", "it gives no light from 360 to 830 nm",
                  "give it some, or remove it");
        return;
    }
    const auto* point = std::get_if<PointLight>(&scene.lights[i]);
    const Place* shell = point != nullptr ? shell_of(scene, places, point->position) : nullptr;
    if (shell == nullptr) return;
    sink.warn(at, "lamp-shut-in",
              "it stands inside \"" + scene.objects[shell->object].name +
                  "\", which is opaque: nothing outside gets its light",
              "move it out, or let light go through what is around it");
}

void warn_of_ambient(const renderer::AmbientDescription& ambient, WarningSink& sink) {
    if (ambient.k_a > 1 + kSlack && !ambient.illuminant) {
        sink.warn("/ambient/k_a", "ambient-above-one",
                  "neighbours give back " + number_text(ambient.k_a) + " times their light",
                  "let k_a be at most 1, or give an illuminant");
    }
    const auto* given = std::get_if<renderer::ExplicitWeights>(&ambient.weights);
    if (given == nullptr) return;
    const Real sum = std::accumulate(given->k.begin(), given->k.end(), Real(0));
    if (!(sum > 1 + kSlack)) return;
    sink.warn("/ambient/weights", "ambient-above-one",
              "the weights of the neighbours are " + number_text(sum) + " in sum",
              "let them be shares of the hemisphere: at most 1 in sum");
}

/// What lamps and environment give to a white surface where the camera looks that faces them, in Y.
double white_luminance(const SceneDescription& scene) {
    double sum = scene.environment ? renderer::xyz_of(*scene.environment->radiance).y : 0;
    for (const LightDescription& light : scene.lights) {
        const double y = renderer::xyz_of(spectrum_of(light)).y;
        if (const auto* point = std::get_if<PointLight>(&light)) {
            const Real metres = length(point->position - target_of(scene)) * scene.metres_per_unit;
            if (metres > 0) sum += y / (metres * metres);
        } else {
            sum += y;
        }
    }
    return sum;
}

}  // namespace

bool is_dark(const SceneDescription& scene) {
    if (scene.environment && !is_black(*scene.environment->radiance)) return false;
    if (scene.ambient && scene.ambient->illuminant && !is_black(*scene.ambient->illuminant))
        return false;
    return std::all_of(scene.lights.begin(), scene.lights.end(),
                       [](const auto& light) { return is_black(spectrum_of(light)); }) &&
           !anything_shines(scene);
}

void warn_of_lights(const SceneDescription& scene, const std::vector<Place>& places,
                    WarningSink& sink) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i) warn_of_lamp(scene, places, i, sink);
    if (scene.ambient) warn_of_ambient(*scene.ambient, sink);
    if (scene.objects.empty() || !is_dark(scene)) return;
    sink.warn("", "no-light", "nothing gives light: the picture will be black",
              "add a lamp or an environment");
}

void warn_of_exposure(const SceneDescription& scene, const renderer::OutputSettings& output,
                      WarningSink& sink) {
    constexpr double kStops = 10;
    if (!output.exposure || anything_shines(scene) || is_dark(scene)) return;
    const double stops = std::log2(white_luminance(scene) * *output.exposure);
    // A lamp in the very place where the camera looks tells nothing.
    if (!std::isfinite(stops) || std::abs(stops) <= kStops) return;
    sink.warn(scene.lights.empty() ? "/environment" : "/lights",
              stops > 0 ? "lamps-too-bright" : "lamps-too-dark",
              "a white surface where the camera looks is " +
                  number_text(std::round(std::abs(stops))) + " stops " +
                  (stops > 0 ? "brighter" : "darker") + " than white at this exposure",
              "see that lengths and lamps are in the scene's units, or leave the exposure to the "
              "renderer");
}

}  // namespace bouguer::api
