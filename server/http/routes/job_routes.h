// SPDX-License-Identifier: Apache-2.0
// /v1/jobs: submit, list, read, wait, cancel, delete.
#pragma once

#include "server/http/http_options.h"
#include "server/http/router.h"
#include "server/jobs/job_service.h"

namespace bouguer::server {

/// `jobs` outlives the router.
void add_job_routes(Router& router, JobService& jobs, const HttpDeadlines& deadlines);

}  // namespace bouguer::server
