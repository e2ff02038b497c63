// SPDX-License-Identifier: Apache-2.0
// The files that scenes name, below one folder.
#pragma once

#include <cstddef>
#include <filesystem>

#include "api/job_document.h"
#include "renderer/geometry/mesh_file.h"

namespace bouguer::server {

/// Nothing outside the folder is read: names are relative and without "..", and the real path,
/// symbolic links resolved, must still be inside. Immutable, thread-safe.
class FolderAssetSource final : public api::AssetSource {
  public:
    struct Limits {
        std::size_t file_bytes = std::size_t{1} << 30U;
        renderer::MeshLimits mesh{};
    };

    /// `root` need not exist: then no file is found.
    explicit FolderAssetSource(std::filesystem::path root) : FolderAssetSource(root, Limits()) {}
    FolderAssetSource(std::filesystem::path root, const Limits& limits)
        : root_(std::move(root)), limits_(limits) {}

    /// NotFound: no such file, or not inside. TooLarge. InvalidInput: a bad name, or no mesh.
    [[nodiscard]] Result<std::shared_ptr<const renderer::TriangleMesh>> mesh(
        std::string_view name) const override;

  private:
    [[nodiscard]] Result<std::filesystem::path> resolve(std::string_view name) const;

    std::filesystem::path root_;
    Limits limits_;
};

}  // namespace bouguer::server
