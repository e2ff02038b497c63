// SPDX-License-Identifier: Apache-2.0
// Jobs in memory: for the command line and for tests.
#pragma once

#include <map>
#include <mutex>

#include "server/storage/job_store.h"

namespace bouguer::server {

/// Forgets everything when it is destroyed.
class MemoryJobStore : public JobStore {
  public:
    [[nodiscard]] Result<InsertedJob> insert(const Job& job, const IdempotencyKey& key) override;
    [[nodiscard]] Result<Job> find(const JobId& id) const override;
    [[nodiscard]] Result<std::string> request(const JobId& id) const override;
    [[nodiscard]] Result<std::optional<InsertedJob>> find_key(
        const IdempotencyKey& key) const override;
    [[nodiscard]] Result<JobListing> list(std::size_t limit, const std::string& cursor,
                                          std::optional<JobState> state) const override;
    [[nodiscard]] Result<Job> transition(const JobId& id, const Transition& change) override;
    [[nodiscard]] Result<void> remove(const JobId& id) override;
    [[nodiscard]] Result<std::vector<Job>> unfinished() const override;
    [[nodiscard]] Result<std::vector<JobId>> removed() const override;
    [[nodiscard]] Result<void> forget_removed() override;
    [[nodiscard]] Result<std::vector<std::pair<JobId, JobState>>> states() const override;
    [[nodiscard]] Result<void> probe() override { return {}; }

  private:
    struct Key {
        std::string fingerprint;
        JobId job;
    };
    [[nodiscard]] Result<std::optional<InsertedJob>> known(const IdempotencyKey& key) const;

    mutable std::mutex mutex_;
    std::map<JobId, Job> jobs_;        // guarded by mutex_
    std::map<std::string, Key> keys_;  // guarded by mutex_
    std::vector<JobId> removed_;       // guarded by mutex_
};

}  // namespace bouguer::server
