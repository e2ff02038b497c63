// SPDX-License-Identifier: Apache-2.0
// Whether the jobs and the results that were found at the start belong together.
#pragma once

#include <string>
#include <vector>

#include "server/storage/job_store.h"
#include "server/storage/result_store.h"

namespace bouguer::server {

/// What one store knows and the other does not. Results are stored before their job is done, and a
/// removed job is noted until its results are gone, so that no crash leaves any of these: a part
/// was lost, or what stands here is not of the same time.
struct StoreGaps {
    std::vector<JobId> jobs_lost;     ///< there are results of them
    std::vector<JobId> results_lost;  ///< of jobs that are done
    [[nodiscard]] bool empty() const { return jobs_lost.empty() && results_lost.empty(); }
};

[[nodiscard]] Result<StoreGaps> find_gaps(const JobStore& jobs, const ResultStore& results);

/// One sentence with the numbers.
[[nodiscard]] std::string describe(const StoreGaps& gaps);

/// Before anything else uses the stores: removes what is left of removed jobs and looks for gaps.
/// Internal, code "storage-incomplete", when there are any, unless `accept_loss`: then results
/// without a job are set aside.
[[nodiscard]] Result<void> settle_stores(JobStore& jobs, ResultStore& results, bool accept_loss);

}  // namespace bouguer::server
