// SPDX-License-Identifier: Apache-2.0
#include "server/storage/memory_result_store.h"

#include "api/digest.h"

namespace bouguer::server {

Result<void> MemoryResultStore::put(const JobId& id, const ResultFiles& files) {
    if (auto good = check_results(id, files); !good) return good;
    std::map<std::string, StoredFile> stored;
    for (const auto& [name, bytes] : files) stored[name] = {Content(bytes), api::sha256_hex(bytes)};
    const std::lock_guard lock(mutex_);
    jobs_[id] = std::move(stored);
    return {};
}

Result<StoredFile> MemoryResultStore::get(const JobId& id, const std::string& name) const {
    const std::lock_guard lock(mutex_);
    const auto job = jobs_.find(id);
    if (job != jobs_.end()) {
        const auto file = job->second.find(name);
        if (file != job->second.end()) return file->second;
    }
    return fail(ErrorKind::NotFound, "no such result");
}

Result<std::vector<std::string>> MemoryResultStore::names(const JobId& id) const {
    const std::lock_guard lock(mutex_);
    std::vector<std::string> names;
    const auto job = jobs_.find(id);
    if (job == jobs_.end()) return names;
    for (const auto& [name, file] : job->second) names.push_back(name);
    return names;
}

Result<void> MemoryResultStore::remove(const JobId& id) {
    const std::lock_guard lock(mutex_);
    jobs_.erase(id);
    return {};
}

Result<std::vector<JobId>> MemoryResultStore::jobs() const {
    const std::lock_guard lock(mutex_);
    std::vector<JobId> ids;
    for (const auto& [id, files] : jobs_) ids.push_back(id);
    return ids;
}

}  // namespace bouguer::server
