// SPDX-License-Identifier: Apache-2.0
// From a job's request to a render that is ready to begin.
#pragma once

#include "api/job_document.h"
#include "server/jobs/render_task.h"
#include "server/jobs/scene_cache.h"

namespace bouguer::server {

/// Builds the scene, or takes it from the cache, and the film. Errors as build_scene() and
/// Render::create(). Takes as long as the scene is large: on a worker.
[[nodiscard]] Result<PreparedRender> prepare_render(const api::JobRequest& job, SceneCache& scenes);

}  // namespace bouguer::server
