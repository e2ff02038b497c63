// SPDX-License-Identifier: Apache-2.0
#include "server/storage/group_commit.h"

#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Transaction.h>
#include <sqlite3.h>

#include <algorithm>

#include "server/storage/sqlite_schema.h"

namespace bouguer::server {

void GroupCommit::run(Work work, bool flushes) {
    Request request{std::move(work), flushes};
    std::unique_lock lock(mutex_);
    waiting_.push_back(&request);
    while (!request.is_done) {
        if (is_committing_) {
            done_.wait(lock);
            continue;
        }
        is_committing_ = true;
        Batch batch;
        batch.swap(waiting_);
        lock.unlock();
        commit(batch);
        lock.lock();
        for (Request* one : batch) one->is_done = true;
        is_committing_ = false;
        done_.notify_all();
    }
    if (request.error) std::rethrow_exception(request.error);
}

void GroupCommit::commit(const Batch& batch) {
    try {
        commit_guarded(batch);
    } catch (...) {
        for (Request* request : batch) {
            if (!request->error) request->error = std::current_exception();
        }
    }
}

void GroupCommit::commit_guarded(const Batch& batch) {
    const std::lock_guard lock(guard_);
    set_flushes(
        std::any_of(batch.begin(), batch.end(), [](const Request* r) { return r->flushes; }));
    SQLite::Transaction transaction(database_, SQLite::TransactionBehavior::IMMEDIATE);
    for (Request* request : batch) do_one(*request);
    transaction.commit();
}

void GroupCommit::do_one(Request& request) {
    database_.exec("SAVEPOINT one");
    bool is_kept = false;
    try {
        is_kept = request.work(database_);
    } catch (...) {
        request.error = std::current_exception();
        // After some errors SQLite undoes the whole transaction by itself: then all have failed.
        if (sqlite3_get_autocommit(database_.getHandle()) != 0) throw;
    }
    if (!is_kept) database_.exec("ROLLBACK TO one");
    database_.exec("RELEASE one");
}

void GroupCommit::set_flushes(bool wanted) {
    if (wanted == flushes_) return;
    database_.exec(wanted ? kFlushedCommits : kUnflushedCommits);
    flushes_ = wanted;
}

}  // namespace bouguer::server
