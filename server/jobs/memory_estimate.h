// SPDX-License-Identifier: Apache-2.0
// How much memory a job will take, before anything is allocated.
#pragma once

#include <cstdint>

#include "api/job_document.h"

namespace bouguer::server {

/// Bytes of the built scene: shapes, meshes and what Embree makes of them. An upper estimate.
[[nodiscard]] std::uint64_t scene_memory_bytes(const renderer::SceneDescription& scene);

/// Bytes of everything that rendering the job holds: scene, film, pictures on their way out.
[[nodiscard]] std::uint64_t job_memory_bytes(const api::JobRequest& job);

}  // namespace bouguer::server
