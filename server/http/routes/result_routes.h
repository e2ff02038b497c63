// SPDX-License-Identifier: Apache-2.0
// What a job has made: images by name and by Accept, report, error curve, plan, health.
#pragma once

#include "server/http/router.h"
#include "server/jobs/job_service.h"

namespace bouguer::server {

/// `jobs` outlives the router.
void add_result_routes(Router& router, const JobService& jobs);

}  // namespace bouguer::server
