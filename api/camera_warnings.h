// SPDX-License-Identifier: Apache-2.0
// Cameras that see nothing.
#pragma once

#include <vector>

#include "api/placed_objects.h"
#include "api/warning_sink.h"
#include "renderer/scene/description.h"

namespace bouguer::api {

/// Only what is certain: every object lies outside the view, however wide the picture, or the
/// camera stands inside an opaque body without a light. `places` are places_of() the scene.
void warn_of_camera(const renderer::SceneDescription& scene, const std::vector<Place>& places,
                    WarningSink& sink);

}  // namespace bouguer::api
