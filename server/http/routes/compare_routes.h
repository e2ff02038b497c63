// SPDX-License-Identifier: Apache-2.0
// GET /v1/compare: how different two jobs' pictures look.
#pragma once

#include "server/http/image_work.h"
#include "server/http/router.h"
#include "server/jobs/job_service.h"

namespace bouguer::server {

/// `jobs` and `images` outlive the router. A comparison takes a turn of `images`.
void add_compare_routes(Router& router, const JobService& jobs, ImageWork& images);

}  // namespace bouguer::server
