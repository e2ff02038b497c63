// SPDX-License-Identifier: Apache-2.0
// Uploaded files in memory: for tests.
#pragma once

#include <map>
#include <mutex>

#include "server/storage/asset_store.h"

namespace bouguer::server {

/// Forgets everything when it is destroyed.
class MemoryAssetStore final : public AssetStore {
  public:
    explicit MemoryAssetStore(const AssetStoreLimits& limits = {}) : limits_(limits) {}

    [[nodiscard]] Result<Put> put(const std::string& digest, std::string_view bytes) override;
    [[nodiscard]] Result<std::string> get(const std::string& digest) const override;
    [[nodiscard]] bool has(const std::string& digest) const override;

  private:
    const AssetStoreLimits limits_;
    mutable std::mutex mutex_;
    std::map<std::string, std::string> files_;  // guarded by mutex_
    std::uint64_t total_bytes_ = 0;             // guarded by mutex_
};

}  // namespace bouguer::server
