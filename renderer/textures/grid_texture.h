// SPDX-License-Identifier: Apache-2.0
// Lines on a ground, as in the "mesh background" of the seed paper's figures.
#pragma once

#include "renderer/textures/texture.h"
#include "renderer/textures/uv_mapping.h"

namespace bouguer::renderer {

/// One line each way a repetition, along the borders of the texture's unit square, half of it on
/// either side. `width` in [0, 1] is that of a line, as a share of the repetition. Exact at every
/// point.
[[nodiscard]] TexturePtr grid_texture(SpectrumPtr line, SpectrumPtr ground, Real width,
                                      const UvMapping& mapping);

}  // namespace bouguer::renderer
