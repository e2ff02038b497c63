// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/material.h"

#include "renderer/materials/material_textures.h"
#include "renderer/spectrum/refractive_index.h"

namespace bouguer::renderer {

bool has_inside(const MaterialNeeds& needs) {
    return needs.absorbs || !needs.ior->is_constant() || needs.ior->at(kLineD_nm) != 1;
}

Surface bind(const MaterialDescription& material, const SpectralBasis& basis,
             SpectralTable& table) {
    Surface surface =
        std::visit([&](const auto& model) { return bind(model, basis, table); }, material.model);
    if (material.emission.spectrum)
        surface.emission = bind_emission(material.emission, basis, table);
    surface.has_texture = !textures_of(material).empty();
    return surface;
}

}  // namespace bouguer::renderer
