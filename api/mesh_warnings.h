// SPDX-License-Identifier: Apache-2.0
// Meshes: what their files had and is not read, and surfaces that light goes through and that are
// no good.
#pragma once

#include "api/warning_sink.h"
#include "renderer/scene/description.h"

namespace bouguer::api {

/// Of a scene whose meshes have been mended; once for a mesh, however many objects have it.
void warn_of_meshes(const renderer::SceneDescription& scene, WarningSink& sink);

}  // namespace bouguer::api
