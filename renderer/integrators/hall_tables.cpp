// SPDX-License-Identifier: Apache-2.0
#include "renderer/integrators/hall_tables.h"

#include <algorithm>
#include <set>

namespace bouguer::renderer {
HallTables::HallTables(const Scene& scene, const SpectralBasis& basis)
    : spectra(basis.size()), object_surface(scene.object_materials()), bodies(scene.bodies()) {
    // What no object uses stays unbound: the basis was chosen without it.
    surfaces.resize(scene.materials().size());
    const std::set<std::uint32_t> used(object_surface.begin(), object_surface.end());
    for (const std::uint32_t m : used) {
        surfaces[m] = bind(scene.materials()[m], basis, spectra);
    }
    for (const Light& light : scene.lights()) {
        light_emission.push_back(spectra.add(basis.emission(*light.spectrum())));
    }
    if (scene.environment())
        environment = spectra.add(basis.emission(*scene.environment()->radiance));
    if (scene.ambient() && scene.ambient()->illuminant) {
        ambient_illuminant = spectra.add(basis.emission(*scene.ambient()->illuminant));
    }
    const auto note = [&](std::size_t number) {
        brightest_emission =
            std::max(brightest_emission, largest(spectra.row(number), spectra.blocks()));
    };
    if (environment) note(*environment);
    for (const std::uint32_t m : used) {
        if (!surfaces[m].emission) continue;
        for (std::size_t i = 0; i < surfaces[m].emission->count; ++i)
            note(surfaces[m].emission->first + i);
    }
}

}  // namespace bouguer::renderer
