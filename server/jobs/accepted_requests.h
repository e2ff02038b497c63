// SPDX-License-Identifier: Apache-2.0
// What submitting has read of jobs that wait, so that no document is read and no file decoded
// twice.
#pragma once

#include <cstdint>
#include <list>
#include <mutex>
#include <optional>

#include "api/job_document.h"
#include "server/jobs/job_id.h"

namespace bouguer::server {

/// Keeps requests from when a job is accepted until it begins, up to a size: what is dropped is
/// read again from the store. Thread-safe.
class AcceptedRequests {
  public:
    explicit AcceptedRequests(std::uint64_t max_bytes) : max_bytes_(max_bytes) {}

    /// Keeps the request of a job that has none here, without its text. It takes `bytes` of memory:
    /// those kept longest make room, and what is larger than all the room is not kept.
    void keep(const JobId& id, api::JobRequest request, std::uint64_t bytes);
    /// The request, which is no longer kept; empty when it is not here.
    [[nodiscard]] std::optional<api::JobRequest> take(const JobId& id);
    /// Forgets it, if it is here.
    void drop(const JobId& id) { static_cast<void>(take(id)); }

  private:
    struct Entry {
        JobId id;
        std::uint64_t bytes;
        api::JobRequest request;
    };

    const std::uint64_t max_bytes_;
    std::mutex mutex_;
    std::list<Entry> entries_;       // guarded by mutex_; the newest last
    std::uint64_t total_bytes_ = 0;  // guarded by mutex_
};

}  // namespace bouguer::server
