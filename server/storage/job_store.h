// SPDX-License-Identifier: Apache-2.0
// Where jobs are kept. Every backend passes tests/server/storage/job_store_contract.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "renderer/core/result.h"
#include "server/jobs/job.h"

namespace bouguer::server {

/// The client's own name for a request, so that sending it twice makes one job.
struct IdempotencyKey {
    std::string key;          ///< empty: none was given
    std::string fingerprint;  ///< digest of the request's body
};

struct InsertedJob {
    Job job;                ///< the new one, or the one that the key made before
    bool replayed = false;  ///< the key was seen with the same fingerprint: nothing was stored
};

struct JobListing {
    std::vector<Job> jobs;    ///< newest first
    std::string next_cursor;  ///< for the following page; empty on the last
};

/// A change of state and what is written with it.
struct Transition {
    JobState from, to;
    std::int64_t now_ms = 0;     ///< Unix time; becomes started_ms or ended_ms
    std::string failure{};       ///< kept when `to` is Failed
    JobProgress progress{};      ///< kept when `to` is final
    std::string failure_code{};  ///< kept when `to` is Failed
    /// Of Running -> Queued: the process stops in order, so that this begin does not count as one
    /// that ended it.
    bool takes_begin_back = false;
};

/// Thread-safe; may block on a disk, never on a render. Jobs that come out carry no request
/// document: those can be large, and only the worker that begins the job wants it. What has
/// returned survives a crash, but for Queued -> Running, which a power loss may undo: the job is
/// begun again then anyhow. Errors: Internal when the store itself fails, with the code
/// "storage-full" or "storage-failed": nothing was changed then, and the same call may go well
/// later.
class JobStore {
  public:
    virtual ~JobStore() = default;

    /// Stores job and key together or not at all. Conflict: the id exists. InvalidInput, code
    /// "idempotency-key-reused": the key was seen with another fingerprint.
    [[nodiscard]] virtual Result<InsertedJob> insert(const Job& job, const IdempotencyKey& key) = 0;
    /// NotFound.
    [[nodiscard]] virtual Result<Job> find(const JobId& id) const = 0;
    /// The canonical job document. NotFound.
    [[nodiscard]] virtual Result<std::string> request(const JobId& id) const = 0;
    /// The job that an earlier insert with this key made; empty when the key is new.
    [[nodiscard]] virtual Result<std::optional<InsertedJob>> find_key(
        const IdempotencyKey& key) const = 0;
    /// At most `limit` jobs older than `cursor` (empty: from the newest), only those in `state` if
    /// given. InvalidInput, code "bad-cursor".
    [[nodiscard]] virtual Result<JobListing> list(std::size_t limit, const std::string& cursor,
                                                  std::optional<JobState> state) const = 0;
    /// Atomic compare-and-set through the table of legal transitions; the job after it. NotFound;
    /// Conflict when the job is not in `from` or the table does not allow it.
    [[nodiscard]] virtual Result<Job> transition(const JobId& id, const Transition& change) = 0;
    /// Removes the job and its idempotency key, and notes in the same transaction that its results
    /// are to go. NotFound.
    [[nodiscard]] virtual Result<void> remove(const JobId& id) = 0;
    /// Jobs that were removed since the last forget_removed().
    [[nodiscard]] virtual Result<std::vector<JobId>> removed() const = 0;
    [[nodiscard]] virtual Result<void> forget_removed() = 0;
    /// Queued and running jobs, oldest first: what a restart goes on with.
    [[nodiscard]] virtual Result<std::vector<Job>> unfinished() const = 0;
    /// Id and state of every job, in no order.
    [[nodiscard]] virtual Result<std::vector<std::pair<JobId, JobState>>> states() const = 0;
    /// Writes something and flushes it, to learn whether the store would keep what comes.
    [[nodiscard]] virtual Result<void> probe() = 0;
};

/// The one place that says what a transition does to a job: state, times, failure, revision.
/// Conflict as JobStore::transition. For backends.
[[nodiscard]] Result<void> apply_transition(Job& job, const Transition& change);

/// Whether `cursor` is one that list() gives out. For backends.
[[nodiscard]] Result<void> check_cursor(const std::string& cursor);

/// The refusal of a key that came with another body. For backends.
[[nodiscard]] tl::unexpected<Error> key_reused();

}  // namespace bouguer::server
