// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/prepare_render.h"

#include "server/jobs/memory_estimate.h"

namespace bouguer::server {

Result<PreparedRender> prepare_render(const api::JobRequest& job, SceneCache& scenes) {
    const auto begin = std::chrono::steady_clock::now();
    auto scene = scenes.get(scene_key(job), scene_memory_bytes(job.scene),
                            [&] { return renderer::build_scene(job.scene); });
    if (!scene) return tl::unexpected(scene.error());
    auto render = renderer::Render::create(*scene, job.settings, job.stop);
    if (!render) return tl::unexpected(render.error());
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    return PreparedRender{std::move(*render), job.output, {job.digest, job.scene_digest},
                          spent.count(),      job.notes,  job.warnings};
}

}  // namespace bouguer::server
