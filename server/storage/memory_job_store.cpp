// SPDX-License-Identifier: Apache-2.0
#include "server/storage/memory_job_store.h"

namespace bouguer::server {
namespace {

Job without_request(Job job) {
    job.request.clear();
    return job;
}

tl::unexpected<Error> no_such_job() { return fail(ErrorKind::NotFound, "no such job"); }

}  // namespace

Result<std::optional<InsertedJob>> MemoryJobStore::known(const IdempotencyKey& key) const {
    const auto it = keys_.find(key.key);
    if (key.key.empty() || it == keys_.end()) return std::optional<InsertedJob>{};
    if (it->second.fingerprint != key.fingerprint) return key_reused();
    return InsertedJob{without_request(jobs_.at(it->second.job)), true};
}

Result<InsertedJob> MemoryJobStore::insert(const Job& job, const IdempotencyKey& key) {
    const std::lock_guard lock(mutex_);
    auto before = known(key);
    if (!before) return tl::unexpected(before.error());
    if (*before) return **before;
    if (!jobs_.emplace(job.id, job).second) return fail(ErrorKind::Conflict, "the job exists");
    if (!key.key.empty()) keys_[key.key] = {key.fingerprint, job.id};
    return InsertedJob{without_request(job), false};
}

Result<Job> MemoryJobStore::find(const JobId& id) const {
    const std::lock_guard lock(mutex_);
    const auto it = jobs_.find(id);
    if (it == jobs_.end()) return no_such_job();
    return without_request(it->second);
}

Result<std::string> MemoryJobStore::request(const JobId& id) const {
    const std::lock_guard lock(mutex_);
    const auto it = jobs_.find(id);
    if (it == jobs_.end()) return no_such_job();
    return it->second.request;
}

Result<std::optional<InsertedJob>> MemoryJobStore::find_key(const IdempotencyKey& key) const {
    const std::lock_guard lock(mutex_);
    return known(key);
}

Result<JobListing> MemoryJobStore::list(std::size_t limit, const std::string& cursor,
                                        std::optional<JobState> state) const {
    if (auto good = check_cursor(cursor); !good) return tl::unexpected(good.error());
    const std::lock_guard lock(mutex_);
    JobListing page;
    const auto end = cursor.empty() ? jobs_.end() : jobs_.lower_bound(cursor);
    for (auto it = std::make_reverse_iterator(end); it != jobs_.rend(); ++it) {
        if (state && it->second.state != *state) continue;
        if (page.jobs.size() == limit) {
            page.next_cursor = page.jobs.back().id;
            break;
        }
        page.jobs.push_back(without_request(it->second));
    }
    return page;
}

Result<Job> MemoryJobStore::transition(const JobId& id, const Transition& change) {
    const std::lock_guard lock(mutex_);
    const auto it = jobs_.find(id);
    if (it == jobs_.end()) return no_such_job();
    if (auto done = apply_transition(it->second, change); !done) {
        return tl::unexpected(done.error());
    }
    return without_request(it->second);
}

Result<void> MemoryJobStore::remove(const JobId& id) {
    const std::lock_guard lock(mutex_);
    if (jobs_.erase(id) == 0) return no_such_job();
    std::erase_if(keys_, [&](const auto& entry) { return entry.second.job == id; });
    removed_.push_back(id);
    return {};
}

Result<std::vector<JobId>> MemoryJobStore::removed() const {
    const std::lock_guard lock(mutex_);
    return removed_;
}

Result<void> MemoryJobStore::forget_removed() {
    const std::lock_guard lock(mutex_);
    removed_.clear();
    return {};
}

Result<std::vector<std::pair<JobId, JobState>>> MemoryJobStore::states() const {
    const std::lock_guard lock(mutex_);
    std::vector<std::pair<JobId, JobState>> states;
    for (const auto& [id, job] : jobs_) states.emplace_back(id, job.state);
    return states;
}

Result<std::vector<Job>> MemoryJobStore::unfinished() const {
    const std::lock_guard lock(mutex_);
    std::vector<Job> jobs;
    for (const auto& [id, job] : jobs_) {
        if (!is_final(job.state)) jobs.push_back(without_request(job));
    }
    return jobs;
}

}  // namespace bouguer::server
