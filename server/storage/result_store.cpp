// SPDX-License-Identifier: Apache-2.0
#include "server/storage/result_store.h"

#include "server/jobs/job_id.h"

namespace bouguer::server {

bool is_result_name(std::string_view name) {
    constexpr std::string_view kAllowed = "abcdefghijklmnopqrstuvwxyz0123456789.-_";
    return !name.empty() && name.size() <= 64 && name.front() != '.' &&
           name.find_first_not_of(kAllowed) == std::string_view::npos;
}

Result<void> check_results(const JobId& id, const ResultFiles& files) {
    if (!is_job_id(id)) return fail(ErrorKind::InvalidInput, "not the id of a job");
    for (const auto& [name, bytes] : files) {
        if (!is_result_name(name)) return fail(ErrorKind::InvalidInput, "not the name of a result");
    }
    return {};
}

}  // namespace bouguer::server
