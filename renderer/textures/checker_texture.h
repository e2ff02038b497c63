// SPDX-License-Identifier: Apache-2.0
// A chequerboard of two spectra.
#pragma once

#include "renderer/textures/texture.h"
#include "renderer/textures/uv_mapping.h"

namespace bouguer::renderer {

/// Two by two squares a repetition: `a` lower left and upper right, `b` the others. A whole number
/// of repetitions fits around a closed surface without a seam. Exact at every point.
[[nodiscard]] TexturePtr checker_texture(SpectrumPtr a, SpectrumPtr b, const UvMapping& mapping);

}  // namespace bouguer::renderer
