// SPDX-License-Identifier: Apache-2.0
// Bodies that cannot be seen, or whose insides or priorities count for nothing.
#pragma once

#include <vector>

#include "api/placed_objects.h"
#include "api/warning_sink.h"
#include "renderer/scene/description.h"

namespace bouguer::api {

/// Of a scene whose meshes have been mended; `places` are places_of() it.
void warn_of_bodies(const renderer::SceneDescription& scene, const std::vector<Place>& places,
                    WarningSink& sink);

}  // namespace bouguer::api
