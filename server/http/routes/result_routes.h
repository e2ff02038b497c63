// SPDX-License-Identifier: Apache-2.0
// What a job has made: images by name and by Accept, report, error curve, plan, health.
#pragma once

#include "server/http/image_work.h"
#include "server/http/router.h"
#include "server/jobs/job_service.h"

namespace bouguer::server {

/// `jobs` and `images` outlive the router. A query makes an image anew from the film that the job
/// keeps: a turn of `images` each time, with nothing kept for the next.
void add_result_routes(Router& router, const JobService& jobs, ImageWork& images);

}  // namespace bouguer::server
