// SPDX-License-Identifier: Apache-2.0
// /livez and /readyz. The front answers them itself, so that they do when all else is busy.
#pragma once

#include "server/http/exchange.h"
#include "server/http/router.h"
#include "server/jobs/job_service.h"

namespace bouguer::server {

/// Fills the answer when the exchange is a GET or HEAD of one of the two; else false. Calls
/// JobService::readiness() and queue_length(), which must not block. Does not throw but for memory.
[[nodiscard]] bool answer_health(const JobService& jobs, Exchange& exchange);

/// The same paths for the router, which knows by that that other methods are not allowed.
void add_health_routes(Router& router, const JobService& jobs);

}  // namespace bouguer::server
