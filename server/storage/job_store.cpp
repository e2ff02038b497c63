// SPDX-License-Identifier: Apache-2.0
#include "server/storage/job_store.h"

#include "server/jobs/job_id.h"

namespace bouguer::server {

Result<void> apply_transition(Job& job, const Transition& change) {
    const auto [from, to] = std::pair{change.from, change.to};
    if (job.state != from || !is_legal(from, to)) {
        return fail(ErrorKind::Conflict,
                    "the job is " + std::string(to_string(job.state)) + " and cannot become " +
                        std::string(to_string(to)),
                    "illegal-transition");
    }
    job.state = to;
    ++job.revision;
    if (to == JobState::Running) {
        job.started_ms = change.now_ms;
        ++job.attempts;
    }
    if (to == JobState::Queued) {
        job.started_ms = 0;
        if (change.takes_begin_back && job.attempts > 0) --job.attempts;
    }
    if (to == JobState::Failed) {
        job.failure = change.failure;
        job.failure_code = change.failure_code;
    }
    if (is_final(to)) {
        job.ended_ms = change.now_ms;
        job.progress = change.progress;
    }
    return {};
}

Result<void> check_cursor(const std::string& cursor) {
    if (cursor.empty() || is_job_id(cursor)) return {};
    return fail(ErrorKind::InvalidInput, "the cursor is not one that this server gave",
                "bad-cursor");
}

tl::unexpected<Error> key_reused() {
    return fail(ErrorKind::InvalidInput,
                "the Idempotency-Key was used before with another request body",
                "idempotency-key-reused");
}

}  // namespace bouguer::server
