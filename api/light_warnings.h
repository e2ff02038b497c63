// SPDX-License-Identifier: Apache-2.0
// Lamps that give nothing, too much or too little, and ambient light that is more than the whole.
#pragma once

#include <vector>

#include "api/placed_objects.h"
#include "api/warning_sink.h"
#include "renderer/scene/description.h"
#include "renderer/settings.h"

namespace bouguer::api {

/// `places` are places_of() the scene.
void warn_of_lights(const renderer::SceneDescription& scene, const std::vector<Place>& places,
                    WarningSink& sink);

/// Lamps that give a picture ten stops brighter or darker than what the output shows as white;
/// only where the exposure is given.
void warn_of_exposure(const renderer::SceneDescription& scene,
                      const renderer::OutputSettings& output, WarningSink& sink);

/// Whether nothing gives light: no lamp, environment, emission or ambient illuminant that is there
/// from 360 to 830 nm.
[[nodiscard]] bool is_dark(const renderer::SceneDescription& scene);

}  // namespace bouguer::api
