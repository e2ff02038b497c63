// SPDX-License-Identifier: Apache-2.0
// What is valid in a scene and probably not meant. Every code stands in /docs/warnings.
#pragma once

#include "api/problems.h"
#include "renderer/scene/description.h"
#include "renderer/settings.h"

namespace bouguer::api {

/// Looks at a scene that has no problems and whose meshes have been mended: its materials, meshes,
/// bodies, lights and camera, each in its file. `pointer` is the scene's own. Objects of the
/// description are those of the document, in its order.
void warn_of_scene(const renderer::SceneDescription& scene, const std::string& pointer,
                   Problems& problems);

/// Likewise at what the settings of a job make of a scene.
void warn_of_job(const renderer::SceneDescription& scene, const renderer::RenderSettings& settings,
                 const renderer::OutputSettings& output, const std::string& pointer,
                 Problems& problems);

}  // namespace bouguer::api
