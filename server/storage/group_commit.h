// SPDX-License-Identifier: Apache-2.0
// Transactions of several threads that are committed together, so that they share one flush.
#pragma once

#include <SQLiteCpp/Database.h>

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <vector>

namespace bouguer::server {

/// While one thread waits for the disk, the work of the others gathers; the next of them does all
/// of it in one transaction. What one of them undoes or fails at does not touch the others; when
/// the commit fails, all fail. Thread-safe.
class GroupCommit {
  public:
    /// Changes the database; false undoes what it did. May throw SQLite::Exception, which undoes it
    /// too. Must not begin or end transactions.
    using Work = std::function<bool(SQLite::Database&)>;

    /// `database` is used under `guard` only; both outlive this. It is as prepare_database() leaves
    /// it.
    GroupCommit(SQLite::Database& database, std::mutex& guard)
        : database_(database), guard_(guard) {}

    /// Returns when the work is committed, or undone; when it `flushes`, a power loss does not undo
    /// it any more. Throws SQLite::Exception: nothing was changed.
    void run(Work work, bool flushes);

  private:
    struct Request {
        Work work;
        bool flushes;
        bool is_done = false;
        std::exception_ptr error{};
    };
    using Batch = std::vector<Request*>;

    void commit(const Batch& batch);
    void commit_guarded(const Batch& batch);
    void do_one(Request& request);
    void set_flushes(bool wanted);

    SQLite::Database& database_;  // guarded by guard_
    std::mutex& guard_;
    bool flushes_ = true;  ///< whether a commit waits for the disk; guarded by guard_

    std::mutex mutex_;
    std::condition_variable done_;
    Batch waiting_;               // guarded by mutex_
    bool is_committing_ = false;  ///< one thread is at it; guarded by mutex_
};

}  // namespace bouguer::server
