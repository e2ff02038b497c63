// SPDX-License-Identifier: Apache-2.0
// POST /v1/scenes/validate: problems and plan; nothing is rendered.
#pragma once

#include "server/http/router.h"
#include "server/jobs/job_service.h"

namespace bouguer::server {

/// `jobs` outlives the router.
void add_scene_routes(Router& router, const JobService& jobs);

}  // namespace bouguer::server
