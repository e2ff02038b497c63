// SPDX-License-Identifier: Apache-2.0
#include "server/storage/sqlite_schema.h"

#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <sqlite3.h>

#include <array>
#include <string>

namespace bouguer::server {
namespace {

/// One entry a version of the schema; entry i brings version i to i + 1. Only types and clauses
/// that PostgreSQL has too.
constexpr std::array kMigrations{
    R"sql(
CREATE TABLE jobs (
    id           TEXT PRIMARY KEY,
    state        TEXT NOT NULL
                 CHECK (state IN ('queued', 'running', 'done', 'failed', 'cancelled')),
    priority     INTEGER NOT NULL,
    created_ms   BIGINT NOT NULL,
    started_ms   BIGINT NOT NULL,
    ended_ms     BIGINT NOT NULL,
    revision     BIGINT NOT NULL,
    memory_bytes BIGINT NOT NULL,
    name         TEXT NOT NULL,
    scene_digest TEXT NOT NULL,
    digest       TEXT NOT NULL,
    failure      TEXT NOT NULL,
    fraction     DOUBLE PRECISION NOT NULL,
    samples      BIGINT NOT NULL,
    passes       BIGINT NOT NULL,
    rays         BIGINT NOT NULL,
    seconds      DOUBLE PRECISION NOT NULL,
    rmse               DOUBLE PRECISION,
    rmse_low           DOUBLE PRECISION,
    rmse_high          DOUBLE PRECISION,
    relative_rmse      DOUBLE PRECISION,
    relative_rmse_low  DOUBLE PRECISION,
    relative_rmse_high DOUBLE PRECISION,
    request      TEXT NOT NULL
);
CREATE INDEX jobs_by_state ON jobs (state, id);
CREATE TABLE job_labels (
    job_id TEXT NOT NULL REFERENCES jobs (id) ON DELETE CASCADE,
    name   TEXT NOT NULL,
    value  TEXT NOT NULL,
    PRIMARY KEY (job_id, name)
);
CREATE TABLE idempotency_keys (
    name        TEXT PRIMARY KEY,
    fingerprint TEXT NOT NULL,
    job_id      TEXT NOT NULL REFERENCES jobs (id) ON DELETE CASCADE
);
CREATE INDEX idempotency_keys_by_job ON idempotency_keys (job_id);
)sql",
    R"sql(
ALTER TABLE jobs ADD COLUMN attempts BIGINT NOT NULL DEFAULT 0;
ALTER TABLE jobs ADD COLUMN failure_code TEXT NOT NULL DEFAULT '';
CREATE TABLE removed_jobs (
    job_id TEXT PRIMARY KEY
);
)sql",
};

void set_pragmas(SQLite::Database& db) {
    // Exclusive before the first access: the lock is held as long as the connection, and the log's
    // index lives in our memory instead of a file that others could map.
    db.exec("PRAGMA locking_mode = EXCLUSIVE");
    db.exec("PRAGMA journal_mode = WAL");
    db.exec(kFlushedCommits);
    db.exec("PRAGMA foreign_keys = ON");
}

Result<void> migrate(SQLite::Database& db) {
    SQLite::Transaction transaction(db, SQLite::TransactionBehavior::EXCLUSIVE);
    const int version = db.execAndGet("PRAGMA user_version").getInt();
    const auto newest = static_cast<int>(kMigrations.size());
    if (version < 0 || version > newest) {
        return fail(ErrorKind::Internal,
                    "the job store was written by a newer version of this program",
                    "storage-too-new");
    }
    if (version == newest) return {};  // writes nothing: a full disk can still be started on
    for (int v = version; v < newest; ++v) db.exec(kMigrations.at(static_cast<std::size_t>(v)));
    db.exec("PRAGMA user_version = " + std::to_string(newest));
    transaction.commit();
    return {};
}

}  // namespace

Result<void> prepare_database(SQLite::Database& database) {
    try {
        set_pragmas(database);
        const std::string check = database.execAndGet("PRAGMA quick_check(1)").getString();
        if (check != "ok") {
            return fail(ErrorKind::Internal, "the job store is damaged: " + check,
                        "storage-damaged");
        }
        return migrate(database);
    } catch (const SQLite::Exception& e) {
        if (e.getErrorCode() == SQLITE_BUSY) {
            return fail(ErrorKind::Internal, "another process uses this job store",
                        "storage-in-use");
        }
        if (e.getErrorCode() == SQLITE_CORRUPT || e.getErrorCode() == SQLITE_NOTADB) {
            return fail(ErrorKind::Internal, std::string("the job store is damaged: ") + e.what(),
                        "storage-damaged");
        }
        throw;
    }
}

}  // namespace bouguer::server
