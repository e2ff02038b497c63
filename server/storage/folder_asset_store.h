// SPDX-License-Identifier: Apache-2.0
// Uploaded files as files: ROOT/sha256-<hex>.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>

#include "server/storage/asset_store.h"

namespace bouguer::server {

/// A file is written under a hidden name, flushed to the disk, and appears at once. Other
/// files in the folder are left alone.
class FolderAssetStore final : public AssetStore {
  public:
    /// Makes `root` if need be and clears what a crash left half written. Error{Internal}: not
    /// writable.
    [[nodiscard]] static Result<std::unique_ptr<FolderAssetStore>> open(
        std::filesystem::path root, const AssetStoreLimits& limits = {});

    [[nodiscard]] Result<Put> put(const std::string& digest, std::string_view bytes) override;
    [[nodiscard]] Result<std::string> get(const std::string& digest) const override;
    [[nodiscard]] bool has(const std::string& digest) const override;

  private:
    FolderAssetStore(std::filesystem::path root, const AssetStoreLimits& limits)
        : root_(std::move(root)), limits_(limits) {}

    void count_files();
    [[nodiscard]] bool take_room(std::size_t bytes);
    void give_room_back(std::size_t bytes);
    [[nodiscard]] std::filesystem::path new_part();
    Result<Put> write(const std::string& digest, std::string_view bytes);

    const std::filesystem::path root_;
    const AssetStoreLimits limits_;
    std::mutex mutex_;
    std::uint64_t total_bytes_ = 0;  // guarded by mutex_; files and those that are being written
    std::uint64_t num_parts_ = 0;    // guarded by mutex_
};

}  // namespace bouguer::server
