// SPDX-License-Identifier: Apache-2.0
// The textures of materials.
#pragma once

#include <cstdint>
#include <set>

#include "renderer/materials/material.h"

namespace bouguer::renderer {

using TextureSet = std::set<TexturePtr>;

/// Every texture that a colour or the emission of the material has, once; empty where nothing
/// varies over its surface.
[[nodiscard]] TextureSet textures_of(const MaterialDescription& material);

[[nodiscard]] std::uint64_t memory_bytes_of(const TextureSet& textures);

}  // namespace bouguer::renderer
