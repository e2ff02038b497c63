// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/material_textures.h"

namespace bouguer::renderer {

TextureSet textures_of(const MaterialDescription& material) {
    TextureSet textures{material.emission.texture};
    for (const SurfaceSpectrum& colour : needs_of(material).colours)
        textures.insert(colour.texture);
    textures.erase(nullptr);
    return textures;
}

std::uint64_t memory_bytes_of(const TextureSet& textures) {
    std::uint64_t bytes = 0;
    for (const TexturePtr& texture : textures) bytes += texture->memory_bytes();
    return bytes;
}

}  // namespace bouguer::renderer
