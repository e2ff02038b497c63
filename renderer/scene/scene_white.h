// SPDX-License-Identifier: Apache-2.0
// What is white in a scene.
#pragma once

#include <optional>

#include "renderer/scene/description.h"
#include "renderer/spectrum/colour.h"

namespace bouguer::renderer {

/// The chromaticity of the scene's light by the CIE 1931 observer, if everything that gives light
/// (lamps, environment, illuminant of the ambient light, surfaces) has the same to 1e-6, however
/// bright. Empty: the scene is dark, or its lights differ in colour. Sources that give no visible
/// light, and those without a spectrum, do not count. Thread-safe.
[[nodiscard]] std::optional<Chromaticity> scene_white(const SceneDescription& scene);

}  // namespace bouguer::renderer
