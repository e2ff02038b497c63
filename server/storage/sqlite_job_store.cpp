// SPDX-License-Identifier: Apache-2.0
#include "server/storage/sqlite_job_store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

#include <mutex>
#include <optional>
#include <utility>

#include "server/storage/group_commit.h"
#include "server/storage/sqlite_schema.h"

namespace bouguer::server {

/// The database and the lock that every use of it holds.
struct SqliteJobStore::Connection {
    explicit Connection(const std::filesystem::path& file)
        : database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE) {}
    std::mutex mutex;
    SQLite::Database database;  // guarded by mutex
    GroupCommit commits{database, mutex};
};

namespace {

constexpr const char* kColumns =
    "id, state, priority, created_ms, started_ms, ended_ms, revision, memory_bytes, name, "
    "scene_digest, digest, failure, fraction, samples, passes, rays, seconds, rmse, rmse_low, "
    "rmse_high, relative_rmse, relative_rmse_low, relative_rmse_high, attempts, failure_code";

tl::unexpected<Error> no_such_job() { return fail(ErrorKind::NotFound, "no such job"); }

/// Runs `work` and turns what SQLite throws into an error of the environment.
template <class Work>
auto guarded(Work&& work) -> decltype(work()) {
    try {
        return work();
    } catch (const SQLite::Exception& e) {
        const bool is_full = e.getErrorCode() == SQLITE_FULL;
        return fail(ErrorKind::Internal, std::string("the job store failed: ") + e.what(),
                    is_full ? "storage-full" : "storage-failed");
    }
}

/// Runs `work` as a transaction, which is undone when it returns an error. When it `flushes`, it
/// survives a power loss.
template <class Work>
auto write(GroupCommit& commits, Work&& work, bool flushes = true)
    -> decltype(work(std::declval<SQLite::Database&>())) {
    using Answer = decltype(work(std::declval<SQLite::Database&>()));
    return guarded([&]() -> Answer {
        std::optional<Answer> answer;
        commits.run(
            [&](SQLite::Database& database) {
                answer = work(database);
                return answer->has_value();
            },
            flushes);
        return std::move(*answer);
    });
}

JobState state_from(const std::string& name) {
    return job_state_from(name).value_or(JobState::Failed);
}

std::map<std::string, std::string> read_labels(SQLite::Database& db, const JobId& id) {
    std::map<std::string, std::string> labels;
    SQLite::Statement query(db, "SELECT name, value FROM job_labels WHERE job_id = ?");
    query.bind(1, id);
    while (query.executeStep()) {
        labels[query.getColumn(0).getString()] = query.getColumn(1).getString();
    }
    return labels;
}

/// Three columns from column `i` on.
std::optional<renderer::Estimate> read_estimate(SQLite::Statement& query, int i) {
    if (query.getColumn(i).isNull()) return std::nullopt;
    return renderer::Estimate{query.getColumn(i).getDouble(), query.getColumn(i + 1).getDouble(),
                              query.getColumn(i + 2).getDouble()};
}

/// From column `i` on.
JobProgress read_progress(SQLite::Statement& query, int i) {
    JobProgress progress;
    progress.fraction = query.getColumn(i).getDouble();
    progress.samples = static_cast<std::uint32_t>(query.getColumn(i + 1).getInt64());
    progress.pass = static_cast<std::uint32_t>(query.getColumn(i + 2).getInt64());
    progress.rays = static_cast<std::uint64_t>(query.getColumn(i + 3).getInt64());
    progress.seconds = query.getColumn(i + 4).getDouble();
    progress.rmse = read_estimate(query, i + 5);
    progress.relative_rmse = read_estimate(query, i + 8);
    return progress;
}

/// Three parameters from `i` on.
void bind_estimate(SQLite::Statement& row, int i,
                   const std::optional<renderer::Estimate>& estimate) {
    if (!estimate) {
        for (int k = 0; k < 3; ++k) row.bind(i + k);
        return;
    }
    row.bind(i, estimate->value);
    row.bind(i + 1, estimate->low);
    row.bind(i + 2, estimate->high);
}

/// To parameter `i` and the following.
void bind_progress(SQLite::Statement& row, int i, const JobProgress& progress) {
    row.bind(i, progress.fraction);
    row.bind(i + 1, static_cast<std::int64_t>(progress.samples));
    row.bind(i + 2, static_cast<std::int64_t>(progress.pass));
    row.bind(i + 3, static_cast<std::int64_t>(progress.rays));
    row.bind(i + 4, progress.seconds);
    bind_estimate(row, i + 5, progress.rmse);
    bind_estimate(row, i + 8, progress.relative_rmse);
}

/// The row that `query` stands on; its columns are kColumns.
Job read_job(SQLite::Database& db, SQLite::Statement& query) {
    Job job;
    job.id = query.getColumn(0).getString();
    job.state = state_from(query.getColumn(1).getString());
    job.priority = query.getColumn(2).getInt();
    job.created_ms = query.getColumn(3).getInt64();
    job.started_ms = query.getColumn(4).getInt64();
    job.ended_ms = query.getColumn(5).getInt64();
    job.revision = static_cast<std::uint64_t>(query.getColumn(6).getInt64());
    job.memory_bytes = static_cast<std::uint64_t>(query.getColumn(7).getInt64());
    job.name = query.getColumn(8).getString();
    job.scene_digest = query.getColumn(9).getString();
    job.digest = query.getColumn(10).getString();
    job.failure = query.getColumn(11).getString();
    job.progress = read_progress(query, 12);
    job.attempts = query.getColumn(23).getUInt();
    job.failure_code = query.getColumn(24).getString();
    job.labels = read_labels(db, job.id);
    return job;
}

std::vector<Job> read_jobs(SQLite::Database& db, SQLite::Statement& query) {
    std::vector<Job> jobs;
    while (query.executeStep()) jobs.push_back(read_job(db, query));
    return jobs;
}

std::optional<Job> find_job(SQLite::Database& db, const JobId& id) {
    SQLite::Statement query(db, std::string("SELECT ") + kColumns + " FROM jobs WHERE id = ?");
    query.bind(1, id);
    if (!query.executeStep()) return std::nullopt;
    return read_job(db, query);
}

/// As JobStore::find_key, inside the caller's transaction.
Result<std::optional<InsertedJob>> known_key(SQLite::Database& db, const IdempotencyKey& key) {
    if (key.key.empty()) return std::optional<InsertedJob>{};
    SQLite::Statement query(db, "SELECT fingerprint, job_id FROM idempotency_keys WHERE name = ?");
    query.bind(1, key.key);
    if (!query.executeStep()) return std::optional<InsertedJob>{};
    if (query.getColumn(0).getString() != key.fingerprint) return key_reused();
    auto job = find_job(db, query.getColumn(1).getString());
    if (!job) return std::optional<InsertedJob>{};
    return InsertedJob{std::move(*job), true};
}

void insert_job(SQLite::Database& db, const Job& job) {
    SQLite::Statement row(db, std::string("INSERT INTO jobs (") + kColumns +
                                  ", request) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
                                  "?, ?, ?, ?, ?, ?, ?, ?, "
                                  "?, ?, ?)");
    row.bind(1, job.id);
    row.bind(2, std::string(to_string(job.state)));
    row.bind(3, job.priority);
    row.bind(4, job.created_ms);
    row.bind(5, job.started_ms);
    row.bind(6, job.ended_ms);
    row.bind(7, static_cast<std::int64_t>(job.revision));
    row.bind(8, static_cast<std::int64_t>(job.memory_bytes));
    row.bind(9, job.name);
    row.bind(10, job.scene_digest);
    row.bind(11, job.digest);
    row.bind(12, job.failure);
    bind_progress(row, 13, job.progress);
    row.bind(24, job.attempts);
    row.bind(25, job.failure_code);
    row.bind(26, job.request);
    row.exec();
    for (const auto& [name, value] : job.labels) {
        SQLite::Statement label(db,
                                "INSERT INTO job_labels (job_id, name, value) VALUES (?, ?, ?)");
        label.bind(1, job.id);
        label.bind(2, name);
        label.bind(3, value);
        label.exec();
    }
}

void insert_key(SQLite::Database& db, const IdempotencyKey& key, const JobId& id) {
    if (key.key.empty()) return;
    SQLite::Statement row(
        db, "INSERT INTO idempotency_keys (name, fingerprint, job_id) VALUES (?, ?, ?)");
    row.bind(1, key.key);
    row.bind(2, key.fingerprint);
    row.bind(3, id);
    row.exec();
}

void store_transition(SQLite::Database& db, const Job& job) {
    SQLite::Statement row(
        db,
        "UPDATE jobs SET state = ?, started_ms = ?, ended_ms = ?, revision = ?, failure = ?, "
        "fraction = ?, samples = ?, passes = ?, rays = ?, seconds = ?, rmse = ?, "
        "rmse_low = ?, rmse_high = ?, relative_rmse = ?, relative_rmse_low = ?, relative_rmse_high "
        "= ?, attempts = ?, failure_code = ? WHERE id = ?");
    row.bind(1, std::string(to_string(job.state)));
    row.bind(2, job.started_ms);
    row.bind(3, job.ended_ms);
    row.bind(4, static_cast<std::int64_t>(job.revision));
    row.bind(5, job.failure);
    bind_progress(row, 6, job.progress);
    row.bind(17, job.attempts);
    row.bind(18, job.failure_code);
    row.bind(19, job.id);
    row.exec();
}

}  // namespace

SqliteJobStore::SqliteJobStore(std::unique_ptr<Connection> connection)
    : connection_(std::move(connection)) {}

SqliteJobStore::~SqliteJobStore() = default;

Result<std::unique_ptr<SqliteJobStore>> SqliteJobStore::open(const std::filesystem::path& file) {
    return guarded([&]() -> Result<std::unique_ptr<SqliteJobStore>> {
        auto connection = std::make_unique<Connection>(file);
        if (auto ready = prepare_database(connection->database); !ready) {
            return tl::unexpected(ready.error());
        }
        return std::unique_ptr<SqliteJobStore>(new SqliteJobStore(std::move(connection)));
    });
}

Result<InsertedJob> SqliteJobStore::insert(const Job& job, const IdempotencyKey& key) {
    return write(connection_->commits, [&](SQLite::Database& db) -> Result<InsertedJob> {
        auto before = known_key(db, key);
        if (!before) return tl::unexpected(before.error());
        if (*before) return **before;
        if (find_job(db, job.id)) return fail(ErrorKind::Conflict, "the job exists");
        insert_job(db, job);
        insert_key(db, key, job.id);
        InsertedJob stored{job, false};
        stored.job.request.clear();
        return stored;
    });
}

Result<Job> SqliteJobStore::find(const JobId& id) const {
    const std::lock_guard lock(connection_->mutex);
    return guarded([&]() -> Result<Job> {
        auto job = find_job(connection_->database, id);
        if (!job) return no_such_job();
        return std::move(*job);
    });
}

Result<std::string> SqliteJobStore::request(const JobId& id) const {
    const std::lock_guard lock(connection_->mutex);
    return guarded([&]() -> Result<std::string> {
        SQLite::Statement query(connection_->database, "SELECT request FROM jobs WHERE id = ?");
        query.bind(1, id);
        if (!query.executeStep()) return no_such_job();
        return query.getColumn(0).getString();
    });
}

Result<std::optional<InsertedJob>> SqliteJobStore::find_key(const IdempotencyKey& key) const {
    const std::lock_guard lock(connection_->mutex);
    return guarded([&] { return known_key(connection_->database, key); });
}

Result<JobListing> SqliteJobStore::list(std::size_t limit, const std::string& cursor,
                                        std::optional<JobState> state) const {
    if (auto good = check_cursor(cursor); !good) return tl::unexpected(good.error());
    const std::lock_guard lock(connection_->mutex);
    return guarded([&]() -> Result<JobListing> {
        std::string sql = std::string("SELECT ") + kColumns + " FROM jobs WHERE 1 = 1";
        if (!cursor.empty()) sql += " AND id < :cursor";
        if (state) sql += " AND state = :state";
        sql += " ORDER BY id DESC LIMIT :limit";
        SQLite::Statement query(connection_->database, sql);
        if (!cursor.empty()) query.bind(":cursor", cursor);
        if (state) query.bind(":state", std::string(to_string(*state)));
        query.bind(":limit", static_cast<std::int64_t>(limit) + 1);
        JobListing page{read_jobs(connection_->database, query), {}};
        if (page.jobs.size() > limit) {
            page.jobs.resize(limit);
            if (limit > 0) page.next_cursor = page.jobs.back().id;
        }
        return page;
    });
}

Result<Job> SqliteJobStore::transition(const JobId& id, const Transition& change) {
    // A begin that a power loss undoes is a job that waits, which is begun again all the same. The
    // end of the process does not undo it, and what is flushed later is in the same log behind it.
    const bool flushes = change.to != JobState::Running;
    const auto work = [&](SQLite::Database& db) -> Result<Job> {
        auto job = find_job(db, id);
        if (!job) return no_such_job();
        if (auto done = apply_transition(*job, change); !done) return tl::unexpected(done.error());
        store_transition(db, *job);
        return std::move(*job);
    };
    return write(connection_->commits, work, flushes);
}

Result<void> SqliteJobStore::remove(const JobId& id) {
    return write(connection_->commits, [&](SQLite::Database& db) -> Result<void> {
        SQLite::Statement row(db, "DELETE FROM jobs WHERE id = ?");
        row.bind(1, id);
        if (row.exec() == 0) return no_such_job();
        SQLite::Statement note(db, "INSERT INTO removed_jobs (job_id) VALUES (?)");
        note.bind(1, id);
        note.exec();
        return {};
    });
}

Result<std::vector<Job>> SqliteJobStore::unfinished() const {
    const std::lock_guard lock(connection_->mutex);
    return guarded([&]() -> Result<std::vector<Job>> {
        SQLite::Statement query(connection_->database,
                                std::string("SELECT ") + kColumns +
                                    " FROM jobs WHERE state IN ('queued', 'running') ORDER BY id");
        return read_jobs(connection_->database, query);
    });
}

Result<std::vector<JobId>> SqliteJobStore::removed() const {
    const std::lock_guard lock(connection_->mutex);
    return guarded([&]() -> Result<std::vector<JobId>> {
        std::vector<JobId> ids;
        SQLite::Statement query(connection_->database, "SELECT job_id FROM removed_jobs");
        while (query.executeStep()) ids.push_back(query.getColumn(0).getString());
        return ids;
    });
}

Result<void> SqliteJobStore::forget_removed() {
    return write(connection_->commits, [&](SQLite::Database& db) -> Result<void> {
        db.exec("DELETE FROM removed_jobs");
        return {};
    });
}

Result<std::vector<std::pair<JobId, JobState>>> SqliteJobStore::states() const {
    const std::lock_guard lock(connection_->mutex);
    return guarded([&]() -> Result<std::vector<std::pair<JobId, JobState>>> {
        std::vector<std::pair<JobId, JobState>> states;
        SQLite::Statement query(connection_->database, "SELECT id, state FROM jobs");
        while (query.executeStep()) {
            states.emplace_back(query.getColumn(0).getString(),
                                state_from(query.getColumn(1).getString()));
        }
        return states;
    });
}

Result<void> SqliteJobStore::probe() {
    return write(connection_->commits, [&](SQLite::Database& db) -> Result<void> {
        // The same number again: SQLite does not look and writes the page, as for any transaction.
        const int version = db.execAndGet("PRAGMA user_version").getInt();
        db.exec("PRAGMA user_version = " + std::to_string(version));
        return {};
    });
}

}  // namespace bouguer::server
