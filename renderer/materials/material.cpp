// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/material.h"

#include <algorithm>

namespace bouguer::renderer {

Surface bind(const MaterialDescription& material, const SpectralBasis& basis,
             SpectralTable& table) {
    Surface surface =
        std::visit([&](const auto& model) { return bind(model, basis, table); }, material.model);
    if (material.emission.spectrum)
        surface.emission = bind_emission(material.emission, basis, table);
    const auto colours = needs_of(material).colours;
    surface.has_texture =
        material.emission.texture ||
        std::any_of(colours.begin(), colours.end(), [](const auto& c) { return c.texture; });
    return surface;
}

}  // namespace bouguer::renderer
