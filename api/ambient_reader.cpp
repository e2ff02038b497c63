// SPDX-License-Identifier: Apache-2.0
#include "api/ambient_reader.h"

#include "api/json_reader.h"
#include "api/nearest_name.h"

namespace bouguer::api {
namespace {

constexpr Interval kStrength{0, 1e6};
constexpr std::int64_t kMostRays = 64;

/// Weights by object name; an object that could not be read has its name in `objects` all the same.
renderer::ExplicitWeights read_explicit(const JsonValue& value, const NameIndex& objects) {
    renderer::ExplicitWeights weights;
    weights.k.assign(objects.size(), 0);
    for (const auto& [name, json] : value.json().members()) {
        const JsonValue weight = value.member(name);
        const auto object = objects.find(name);
        if (object == objects.end()) {
            weight.report(
                "unknown-name",
                "there is no object of this name." +
                    (value.problems().is_full() ? "" : did_you_mean(name, words_of(objects))),
                "names of objects");
            continue;
        }
        const auto k = weight.number(kStrength);
        // After a duplicate name there are fewer names than objects.
        if (object->second >= weights.k.size()) weights.k.resize(object->second + 1);
        weights.k[object->second] = k.value_or(0);
    }
    return weights;
}

void read_weights(JsonReader& reader, const NameIndex& objects,
                  renderer::AmbientDescription& ambient) {
    const auto weights = reader.find("weights");
    if (weights && weights->json().is_object()) {
        ambient.weights = read_explicit(*weights, objects);
        return;
    }
    if (weights && !weights->json().is_string()) {
        weights->report_type(
            "\"hemisphere\", \"constant\", or an object of weights by object name");
    } else if (weights && weights->one_of({"hemisphere", "constant"}) == "constant") {
        ambient.weights = renderer::ConstantWeights{};
        return;
    }
    ambient.weights =
        renderer::HemisphereWeights{static_cast<int>(reader.integer("rays", 1, kMostRays, 1))};
}

}  // namespace

std::optional<renderer::AmbientDescription> read_ambient(const JsonValue& value,
                                                         const NameIndex& objects,
                                                         SpectrumReader& spectra) {
    JsonReader reader(value);
    if (!reader.is_object()) return std::nullopt;
    renderer::AmbientDescription ambient;
    ambient.k_a = reader.require_number("k_a", kStrength).value_or(0);
    read_weights(reader, objects, ambient);
    if (const auto at = reader.find("illuminant")) ambient.illuminant = spectra.emission(*at);
    reader.reject_unknown_keys();
    return ambient;
}

}  // namespace bouguer::api
