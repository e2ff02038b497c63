// SPDX-License-Identifier: Apache-2.0
#include "server/storage/store_gaps.h"

#include <algorithm>
#include <set>

#include "server/log.h"

namespace bouguer::server {
namespace {

Result<void> finish_removals(JobStore& jobs, ResultStore& results) {
    const auto removed = jobs.removed();
    if (!removed) return tl::unexpected(removed.error());
    if (removed->empty()) return {};
    const auto with_results = results.jobs();
    if (!with_results) return tl::unexpected(with_results.error());
    const std::set<JobId> there(with_results->begin(), with_results->end());
    for (const JobId& id : *removed) {
        // The last one in any case: what was removed before may not have been flushed, and must not
        // come back when nobody remembers any more that it was removed.
        if (!there.contains(id) && id != removed->back()) continue;
        if (auto gone = results.remove(id); !gone) return gone;
    }
    // A disk that is full now does not keep the daemon from its work: next time, then.
    (void)jobs.forget_removed();
    return {};
}

std::string first_of(const std::vector<JobId>& ids) {
    return ids.empty() ? std::string() : ids.front();
}

void tell(const StoreGaps& gaps) {
    log_event(LogLevel::Warning, "storage-incomplete",
              {{"jobs_lost", std::to_string(gaps.jobs_lost.size())},
               {"first_lost", first_of(gaps.jobs_lost)},
               {"results_lost", std::to_string(gaps.results_lost.size())},
               {"first_without_results", first_of(gaps.results_lost)}});
}

}  // namespace

Result<StoreGaps> find_gaps(const JobStore& jobs, const ResultStore& results) {
    auto states = jobs.states();
    if (!states) return tl::unexpected(states.error());
    auto with_results = results.jobs();
    if (!with_results) return tl::unexpected(with_results.error());
    std::sort(states->begin(), states->end());
    std::sort(with_results->begin(), with_results->end());
    StoreGaps gaps;
    for (const JobId& id : *with_results) {
        const auto job =
            std::lower_bound(states->begin(), states->end(), id,
                             [](const auto& a, const JobId& b) { return a.first < b; });
        if (job == states->end() || job->first != id) gaps.jobs_lost.push_back(id);
    }
    for (const auto& [id, state] : *states) {
        const bool has_results = std::binary_search(with_results->begin(), with_results->end(), id);
        if (state == JobState::Done && !has_results) gaps.results_lost.push_back(id);
    }
    return gaps;
}

std::string describe(const StoreGaps& gaps) {
    return "the data folder is incomplete: there are results of " +
           std::to_string(gaps.jobs_lost.size()) + " jobs that the job store does not know, and " +
           std::to_string(gaps.results_lost.size()) + " finished jobs have no results";
}

Result<void> settle_stores(JobStore& jobs, ResultStore& results, bool accept_loss) {
    if (auto finished = finish_removals(jobs, results); !finished) return finished;
    const auto gaps = find_gaps(jobs, results);
    if (!gaps) return tl::unexpected(gaps.error());
    if (gaps->empty()) return {};
    tell(*gaps);
    if (!accept_loss) {
        return fail(ErrorKind::Internal,
                    describe(*gaps) +
                        "; other jobs may be lost too. Put back what is missing, or "
                        "say --accept-loss to go on without it",
                    "storage-incomplete");
    }
    for (const JobId& id : gaps->jobs_lost) {
        if (auto aside = results.set_aside(id); !aside) return aside;
    }
    return {};
}

}  // namespace bouguer::server
