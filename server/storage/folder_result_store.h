// SPDX-License-Identifier: Apache-2.0
// Results as files: ROOT/<job id>.tar has all that came of one job.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <memory>
#include <mutex>
#include <set>
#include <tuple>

#include "server/storage/result_archive.h"
#include "server/storage/result_store.h"

namespace bouguer::server {

/// A job's archive is written under a hidden name, flushed to the disk and renamed, so that all of
/// it appears at once. What is asked for comes as a part of the open file; its digest is checked
/// when it is first asked for and again when the file changed since. Reads also what earlier
/// versions stored: the same files in a folder ROOT/<job id>, with SHA256SUMS.
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
    [[nodiscard]] Result<std::vector<JobId>> jobs() const override;
    /// Into the folder "lost-results" beside the root.
    [[nodiscard]] Result<void> set_aside(const JobId& id) override;

  private:
    /// An open file and where in it the result stands.
    struct Place {
        Content::File file;
        ArchivedFile where;
    };
    /// A part of a file as it was when it was checked.
    using Checked = std::tuple<dev_t, ino_t, std::int64_t, std::int64_t, std::uint64_t>;

    explicit FolderResultStore(std::filesystem::path root) : root_(std::move(root)) {}
    [[nodiscard]] std::filesystem::path archive_of(const JobId& id) const;
    [[nodiscard]] Result<Place> find(const JobId& id, const std::string& name) const;
    [[nodiscard]] Result<void> check(const Place& place, const Content& content,
                                     const std::string& name) const;

    std::filesystem::path root_;
    mutable std::mutex mutex_;
    mutable std::set<Checked> checked_;  // guarded by mutex_
};

}  // namespace bouguer::server
