// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/material.h"

#include "renderer/materials/material_textures.h"

namespace bouguer::renderer {

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
