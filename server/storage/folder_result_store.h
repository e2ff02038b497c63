// SPDX-License-Identifier: Apache-2.0
// Results as files: ROOT/<job id>/<name>, with their digests in ROOT/<job id>/SHA256SUMS.
#pragma once

#include <filesystem>
#include <memory>

#include "server/storage/result_store.h"

namespace bouguer::server {

/// A job's files are written into a hidden folder beside their place, flushed to the disk, and
/// appear together by one rename. `sha256sum -c SHA256SUMS` checks them by hand.
class FolderResultStore final : public ResultStore {
  public:
    /// Makes `root` if need be and clears what a crash left half written. Error{Internal}: not
    /// writable.
    [[nodiscard]] static Result<std::unique_ptr<FolderResultStore>> open(
        std::filesystem::path root);

    [[nodiscard]] Result<void> put(const JobId& id, const ResultFiles& files) override;
    [[nodiscard]] Result<StoredFile> get(const JobId& id, const std::string& name) const override;
    [[nodiscard]] Result<std::vector<std::string>> names(const JobId& id) const override;
    [[nodiscard]] Result<void> remove(const JobId& id) override;

  private:
    explicit FolderResultStore(std::filesystem::path root) : root_(std::move(root)) {}

    std::filesystem::path root_;
};

}  // namespace bouguer::server
