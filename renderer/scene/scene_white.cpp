// SPDX-License-Identifier: Apache-2.0
#include "renderer/scene/scene_white.h"

#include <cmath>
#include <vector>

namespace bouguer::renderer {
namespace {

constexpr double kSameColour = 1e-6;

/// Of everything that gives light; some may be null.
std::vector<const Spectrum*> light_spectra(const SceneDescription& scene) {
    std::vector<const Spectrum*> spectra;
    for (const LightDescription& light : scene.lights) {
        if (const auto* point = std::get_if<PointLight>(&light))
            spectra.push_back(point->intensity.get());
        if (const auto* directional = std::get_if<DirectionalLight>(&light))
            spectra.push_back(directional->irradiance.get());
    }
    if (scene.environment) spectra.push_back(scene.environment->radiance.get());
    if (scene.ambient) spectra.push_back(scene.ambient->illuminant.get());
    return spectra;
}

bool are_same(Chromaticity a, Chromaticity b) {
    return std::abs(a.x - b.x) <= kSameColour && std::abs(a.y - b.y) <= kSameColour;
}

}  // namespace

std::optional<Chromaticity> scene_white(const SceneDescription& scene) {
    std::optional<Chromaticity> white;
    const Spectrum* last = nullptr;
    for (const Spectrum* spectrum : light_spectra(scene)) {
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
