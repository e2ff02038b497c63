// SPDX-License-Identifier: Apache-2.0
// The files that scenes name, below one folder or two.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "api/job_document.h"

namespace bouguer::server {

/// Nothing outside the folder is read: names are relative and without "..", and the real path,
/// symbolic links resolved, must still be inside. Immutable, thread-safe.
class FolderAssetSource final : public api::AssetSource {
  public:
    static constexpr std::size_t kMaxFileBytes = std::size_t{1} << 30U;

    /// `root` need not exist: then no file is found.
    explicit FolderAssetSource(std::filesystem::path root,
                               std::size_t max_file_bytes = kMaxFileBytes)
        : root_(std::move(root)), max_file_bytes_(max_file_bytes) {}

    /// Files named by a path are below `root`, those named by a digest in `uploads`.
    FolderAssetSource(std::filesystem::path root, std::filesystem::path uploads)
        : root_(std::move(root)), uploads_(std::move(uploads)), max_file_bytes_(kMaxFileBytes) {}

    /// NotFound: no such file, or not inside. TooLarge. InvalidInput: a bad name.
    [[nodiscard]] Result<std::unique_ptr<const renderer::ByteSource>> open(
        std::string_view name) const override;

  private:
    [[nodiscard]] Result<std::filesystem::path> resolve(std::string_view name) const;

    std::filesystem::path root_;
    std::filesystem::path uploads_;  ///< empty: root_
    std::size_t max_file_bytes_;
};

}  // namespace bouguer::server
