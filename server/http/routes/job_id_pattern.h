// SPDX-License-Identifier: Apache-2.0
// Paths of jobs.
#pragma once

#include <string>

namespace bouguer::server {

/// Path of one job, the id as the first group. What is no well-formed UUID is no path: 404.
inline std::string job_path(const std::string& suffix = {}) {
    return "/v1/jobs/([0-9a-f]{8}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{12})" + suffix;
}

}  // namespace bouguer::server
