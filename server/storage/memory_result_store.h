// SPDX-License-Identifier: Apache-2.0
// Results in memory: for the command line and for tests.
#pragma once

#include <mutex>

#include "server/storage/result_store.h"

namespace bouguer::server {

/// Forgets everything when it is destroyed.
class MemoryResultStore final : public ResultStore {
  public:
    [[nodiscard]] Result<void> put(const JobId& id, const ResultFiles& files) override;
    [[nodiscard]] Result<StoredFile> get(const JobId& id, const std::string& name) const override;
    [[nodiscard]] Result<std::vector<std::string>> names(const JobId& id) const override;
    [[nodiscard]] Result<void> remove(const JobId& id) override;
    [[nodiscard]] Result<std::vector<JobId>> jobs() const override;
    [[nodiscard]] Result<void> set_aside(const JobId& id) override { return remove(id); }

  private:
    mutable std::mutex mutex_;
    std::map<JobId, std::map<std::string, StoredFile>> jobs_;  // guarded by mutex_
};

}  // namespace bouguer::server
