// SPDX-License-Identifier: Apache-2.0
#include "renderer/integrators/hall_tables.h"

namespace bouguer::renderer {
HallTables::HallTables(const Scene& scene, const SpectralBasis& basis)
    : spectra(basis.size()),
      object_surface(scene.object_materials()),
      object_is_sheet(scene.object_is_sheet()) {
    for (const MaterialDescription& material : scene.materials()) {
        surfaces.push_back(bind_hall(std::get<HallMaterial>(material.model), basis, spectra));
    }
    for (const Light& light : scene.lights()) {
        light_emission.push_back(spectra.add(basis.emission(*light.spectrum())));
    }
    if (scene.environment())
        environment = spectra.add(basis.emission(*scene.environment()->radiance));
    if (scene.ambient() && scene.ambient()->illuminant) {
        ambient_illuminant = spectra.add(basis.emission(*scene.ambient()->illuminant));
    }
}

}  // namespace bouguer::renderer
