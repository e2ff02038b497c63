// SPDX-License-Identifier: Apache-2.0
// The folder that everything is kept in: is it still the same one, and is there room in it?
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <vector>

#include "renderer/core/result.h"

namespace bouguer::server {

/// Bytes that stay free on a disk of `disk_bytes` for the results of jobs that were accepted: 64
/// MiB, of small disks a twentieth.
[[nodiscard]] std::uint64_t reserved_bytes(std::uint64_t disk_bytes);

/// Remembers which folders and files it was opened on. Immutable; thread-safe.
class DataFolder {
  public:
    /// `entries`: the folder itself first, then what must stay in it. Error{Internal}: one is
    /// missing.
    [[nodiscard]] static Result<DataFolder> open(std::vector<std::filesystem::path> entries);

    /// Error{Internal}, code "storage-failed": an entry is gone or another stands in its place, so
    /// that what is written now is lost; "storage-full": less than reserved_bytes() is free.
    [[nodiscard]] Result<void> check() const;

  private:
    struct Entry {
        std::filesystem::path path;
        dev_t device;
        ino_t inode;
    };
    explicit DataFolder(std::vector<Entry> entries) : entries_(std::move(entries)) {}
    [[nodiscard]] static Result<Entry> look_at(const std::filesystem::path& path);

    std::vector<Entry> entries_;
};

}  // namespace bouguer::server
