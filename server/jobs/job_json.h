// SPDX-License-Identifier: Apache-2.0
// The JSON of a job's progress; that of whole jobs is declared in job_service.h.
#pragma once

#include <string>

#include "server/jobs/job.h"

namespace bouguer::server {

/// {"fraction", "samples", "pass", "rays", "seconds", "seconds_left", "rmse" and "relative_rmse":
/// {"value", "low", "high"}}; null for what is not known.
[[nodiscard]] std::string progress_json(const JobProgress& progress);

/// Data of "progress" and "preview" events: {"id", "progress"}.
[[nodiscard]] std::string progress_event_json(const JobId& id, const JobProgress& progress);

}  // namespace bouguer::server
