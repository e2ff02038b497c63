// SPDX-License-Identifier: Apache-2.0
// The members of a job document beside its scene: integrator, stop, output, seed, priority, labels.
#pragma once

#include "api/job_document.h"
#include "api/json_reader.h"

namespace bouguer::api {

inline constexpr std::string_view kJobFormat = "bouguer-job/1";

/// Reads everything of a job but `format` and `scene` into `job`, whose scene has been read.
void read_job_settings(JsonReader& reader, const Limits& limits, JobRequest& job);

}  // namespace bouguer::api
