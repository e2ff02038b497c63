// SPDX-License-Identifier: Apache-2.0
#include "renderer/scene/scene_white.h"

#include <cmath>
#include <vector>

namespace bouguer::renderer {
namespace {

constexpr double kSameColour = 1e-6;

/// What the surfaces of objects give out by themselves.
void add_emission(const SceneDescription& scene, std::vector<SpectrumPtr>& spectra) {
    std::vector<bool> is_seen(scene.materials.size());
    for (const ObjectDescription& object : scene.objects) {
        if (is_seen[object.material]) continue;
        is_seen[object.material] = true;
        for (SpectrumPtr& part : scene.materials[object.material].emission.parts())
            spectra.push_back(std::move(part));
    }
}

/// Of everything that gives light; some may be null.
std::vector<SpectrumPtr> light_spectra(const SceneDescription& scene) {
    std::vector<SpectrumPtr> spectra;
    for (const LightDescription& light : scene.lights) {
        if (const auto* point = std::get_if<PointLight>(&light))
            spectra.push_back(point->intensity);
        if (const auto* directional = std::get_if<DirectionalLight>(&light))
            spectra.push_back(directional->irradiance);
    }
    if (scene.environment) spectra.push_back(scene.environment->radiance);
    if (scene.ambient) spectra.push_back(scene.ambient->illuminant);
    add_emission(scene, spectra);
    return spectra;
}

bool are_same(Chromaticity a, Chromaticity b) {
    return std::abs(a.x - b.x) <= kSameColour && std::abs(a.y - b.y) <= kSameColour;
}

}  // namespace

std::optional<Chromaticity> scene_white(const SceneDescription& scene) {
    std::optional<Chromaticity> white;
    SpectrumPtr last;
    for (const SpectrumPtr& spectrum : light_spectra(scene)) {
        if (spectrum == nullptr || spectrum == last) continue;
        last = spectrum;
        const Chromaticity colour = chromaticity(xyz_of(*spectrum));
        if (!(colour.y > 0)) continue;
        if (!white) white = colour;
        if (!are_same(*white, colour)) return std::nullopt;
    }
    return white;
}

}  // namespace bouguer::renderer
