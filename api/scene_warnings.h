// SPDX-License-Identifier: Apache-2.0
// What is valid in a scene and probably not meant. Every code stands in /docs/warnings.
#pragma once

#include "api/problems.h"
#include "renderer/scene/description.h"
#include "renderer/settings.h"

namespace bouguer::api {

/// Looks at a scene that has no problems: shares above the whole, materials that nothing uses,
/// inner properties of things without an inside, bodies hidden in others, absorption that leaves
/// nothing. `pointer` is the scene's own. Objects of the description are those of the document, in
/// its order.
void warn_of_scene(const renderer::SceneDescription& scene, const std::string& pointer,
                   Problems& problems);

/// Lamps that give a picture ten stops brighter or darker than what the output shows as white;
/// only where the exposure is given.
void warn_of_exposure(const renderer::SceneDescription& scene,
                      const renderer::OutputSettings& output, const std::string& pointer,
                      Problems& problems);

}  // namespace bouguer::api
