// SPDX-License-Identifier: Apache-2.0
// Stores that refuse to write for a while, as a full or broken disk does.
#pragma once

#include <atomic>

#include "server/storage/memory_job_store.h"
#include "server/storage/memory_result_store.h"

namespace bouguer::server {

/// Which writes fail, and how many of them were asked for in vain. Thread-safe.
struct Fault {
    std::atomic<bool> is_on = false;
    std::atomic<int> left = 0;  ///< that fail also when it is off
    std::atomic<int> refused = 0;

    [[nodiscard]] bool strikes() {
        const bool strikes = is_on || left.fetch_sub(1) > 0;
        if (strikes) ++refused;
        return strikes;
    }
    [[nodiscard]] tl::unexpected<Error> error() const {
        return fail(ErrorKind::Internal, "no space left", "storage-full");
    }
};

class FaultyJobStore final : public JobStore {
  public:
    Fault inserts, begins, ends, probes;
    mutable Fault reads;  ///< of requests

    Result<InsertedJob> insert(const Job& job, const IdempotencyKey& key) override {
        if (inserts.strikes()) return inserts.error();
        return store_.insert(job, key);
    }
    Result<Job> transition(const JobId& id, const Transition& change) override {
        Fault& fault = change.to == JobState::Running ? begins : ends;
        if (fault.strikes()) return fault.error();
        return store_.transition(id, change);
    }
    Result<void> probe() override {
        if (probes.strikes()) return probes.error();
        return store_.probe();
    }
    Result<Job> find(const JobId& id) const override { return store_.find(id); }
    Result<std::string> request(const JobId& id) const override {
        if (reads.strikes()) return reads.error();
        return store_.request(id);
    }
    Result<std::optional<InsertedJob>> find_key(const IdempotencyKey& key) const override {
        return store_.find_key(key);
    }
    Result<JobListing> list(std::size_t limit, const std::string& cursor,
                            std::optional<JobState> state) const override {
        return store_.list(limit, cursor, state);
    }
    Result<void> remove(const JobId& id) override { return store_.remove(id); }
    Result<std::vector<Job>> unfinished() const override { return store_.unfinished(); }
    Result<std::vector<JobId>> removed() const override { return store_.removed(); }
    Result<void> forget_removed() override { return store_.forget_removed(); }
    Result<std::vector<std::pair<JobId, JobState>>> states() const override {
        return store_.states();
    }

  private:
    MemoryJobStore store_;
};

class FaultyResultStore final : public ResultStore {
  public:
    Fault puts;

    Result<void> put(const JobId& id, const ResultFiles& files) override {
        if (puts.strikes()) return puts.error();
        return store_.put(id, files);
    }
    Result<StoredFile> get(const JobId& id, const std::string& name) const override {
        return store_.get(id, name);
    }
    Result<std::vector<std::string>> names(const JobId& id) const override {
        return store_.names(id);
    }
    Result<void> remove(const JobId& id) override { return store_.remove(id); }
    Result<std::vector<JobId>> jobs() const override { return store_.jobs(); }
    Result<void> set_aside(const JobId& id) override { return store_.set_aside(id); }

  private:
    MemoryResultStore store_;
};

}  // namespace bouguer::server
