// SPDX-License-Identifier: Apache-2.0
// GET /v1/jobs/{id}/events: server-sent events.
#pragma once

#include "server/http/http_options.h"
#include "server/http/router.h"
#include "server/jobs/job_service.h"

namespace bouguer::server {

/// The first event is a snapshot, also for a client that comes back with Last-Event-ID: what it
/// missed is in there. "done" is the last. A client that comes back with the id of "done" gets 204,
/// which tells a browser to come no more [HTML §9.2.3]. `jobs` outlives the router.
void add_event_routes(Router& router, JobService& jobs, const HttpOptions& options);

}  // namespace bouguer::server
