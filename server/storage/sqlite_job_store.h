// SPDX-License-Identifier: Apache-2.0
// Jobs in one SQLite file: the record of a single machine.
#pragma once

#include <filesystem>
#include <memory>

#include "server/storage/job_store.h"

namespace bouguer::server {

/// One connection reads, writes and checkpoints, under a mutex: SQLite before 3.51.3 can corrupt
/// its log when several do. WAL with synchronous=FULL, so that a returned insert survives a power
/// loss; writes of several threads share a
/// transaction and its flush. The file is locked for as long as the store lives: a second process
/// is refused.
class SqliteJobStore final : public JobStore {
  public:
    /// Opens or makes the file, checks it (quick_check) and brings the schema up to date.
    /// Error{Internal}: damaged, in use by another process, made by a newer version, disk full.
    [[nodiscard]] static Result<std::unique_ptr<SqliteJobStore>> open(
        const std::filesystem::path& file);
    ~SqliteJobStore() override;

    [[nodiscard]] Result<InsertedJob> insert(const Job& job, const IdempotencyKey& key) override;
    [[nodiscard]] Result<Job> find(const JobId& id) const override;
    [[nodiscard]] Result<std::string> request(const JobId& id) const override;
    [[nodiscard]] Result<std::optional<InsertedJob>> find_key(
        const IdempotencyKey& key) const override;
    [[nodiscard]] Result<JobListing> list(std::size_t limit, const std::string& cursor,
                                          std::optional<JobState> state) const override;
    [[nodiscard]] Result<Job> transition(const JobId& id, const Transition& change) override;
    [[nodiscard]] Result<void> remove(const JobId& id) override;
    [[nodiscard]] Result<std::vector<Job>> unfinished() const override;
    [[nodiscard]] Result<std::vector<JobId>> removed() const override;
    [[nodiscard]] Result<void> forget_removed() override;
    [[nodiscard]] Result<std::vector<std::pair<JobId, JobState>>> states() const override;
    [[nodiscard]] Result<void> probe() override;

  private:
    struct Connection;
    explicit SqliteJobStore(std::unique_ptr<Connection> connection);

    std::unique_ptr<Connection> connection_;
};

}  // namespace bouguer::server
