// SPDX-License-Identifier: Apache-2.0
#include "server/storage/sqlite_job_store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <sys/resource.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <thread>
#include <vector>

#include "tests/server/storage/job_store_contract.h"
#include "tests/server/storage/temporary_folder.h"

namespace bouguer::server {
namespace {

struct SqliteBackend {
    TemporaryFolder folder;
    std::unique_ptr<JobStore> make() {
        return std::move(SqliteJobStore::open(folder.path() / "jobs.sqlite").value());
    }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Sqlite, JobStoreContract, SqliteBackend);

class SqliteJobStoreTest : public testing::Test {
  protected:
    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "jobs.sqlite";
};

TEST_F(SqliteJobStoreTest, KeepsJobsAndKeysWhenItIsOpenedAgain) {
    const Job job = make_job(1);
    {
        auto store = SqliteJobStore::open(file_);
        ASSERT_TRUE(store) << store.error().message;
        ASSERT_TRUE((*store)->insert(job, {"key", "body"}));
        ASSERT_TRUE((*store)->transition(job.id, {JobState::Queued, JobState::Running, 9}));
    }
    auto store = SqliteJobStore::open(file_);
    ASSERT_TRUE(store) << store.error().message;
    EXPECT_EQ((*store)->find(job.id)->state, JobState::Running);
    EXPECT_EQ((*store)->find(job.id)->labels, job.labels);
    EXPECT_EQ((*store)->request(job.id).value(), job.request);
    EXPECT_TRUE((*store)->insert(make_job(2), {"key", "body"})->replayed);
}

// Writes of several threads share transactions: what one of them is refused does not touch the
// rest.
TEST_F(SqliteJobStoreTest, KeepsEveryWriteOfManyThreads) {
    constexpr int kThreads = 8;
    constexpr int kEach = 25;
    {
        auto store = SqliteJobStore::open(file_);
        ASSERT_TRUE(store);
        ASSERT_TRUE((*store)->insert(make_job(9999), {}));
        std::atomic<int> refused = 0;
        std::vector<std::jthread> threads;
        for (int t = 0; t < kThreads; ++t) {
            threads.emplace_back([&, t] {
                for (int i = 0; i < kEach; ++i) {
                    EXPECT_TRUE((*store)->insert(make_job(t * kEach + i), {}));
                    if (!(*store)->insert(make_job(9999), {})) ++refused;
                }
            });
        }
        threads.clear();
        EXPECT_EQ(refused, kThreads * kEach);
    }
    auto store = SqliteJobStore::open(file_);
    ASSERT_TRUE(store);
    EXPECT_EQ((*store)->states()->size(), 1U + kThreads * kEach);
}

// Files that may not grow stand in for a full disk: nothing is changed, and the same call goes well
// later.
TEST_F(SqliteJobStoreTest, AWriteThatFailsChangesNothing) {
    auto store = SqliteJobStore::open(file_);
    ASSERT_TRUE(store);
    rlimit old{};
    getrlimit(RLIMIT_FSIZE, &old);
    const rlimit small{1, old.rlim_max};
    std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    const auto failed = (*store)->insert(make_job(1), {"key", "body"});
    const auto probed = (*store)->probe();
    setrlimit(RLIMIT_FSIZE, &old);
    ASSERT_FALSE(failed);
    EXPECT_TRUE(failed.error().code.starts_with("storage-")) << failed.error().code;
    EXPECT_FALSE(probed) << "a probe must write";
    EXPECT_FALSE((*store)->find(id_number(1)));
    EXPECT_TRUE((*store)->insert(make_job(1), {"key", "body"}));
}

TEST_F(SqliteJobStoreTest, RefusesASecondOwner) {
    auto first = SqliteJobStore::open(file_);
    ASSERT_TRUE(first);
    const auto second = SqliteJobStore::open(file_);
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().code, "storage-in-use");
    EXPECT_TRUE((*first)->insert(make_job(1), {}));
}

TEST_F(SqliteJobStoreTest, RefusesAFileThatIsNoDatabase) {
    std::ofstream(file_) << std::string(5000, 'x');
    const auto store = SqliteJobStore::open(file_);
    ASSERT_FALSE(store);
    EXPECT_EQ(store.error().code, "storage-damaged");
}

// quick_check must find a page that was overwritten behind SQLite's back.
TEST_F(SqliteJobStoreTest, RefusesADamagedDatabase) {
    {
        auto store = SqliteJobStore::open(file_);
        ASSERT_TRUE(store);
        for (int n = 0; n < 200; ++n) ASSERT_TRUE((*store)->insert(make_job(n), {}));
    }
    const auto size = std::filesystem::file_size(file_);
    std::fstream file(file_, std::ios::in | std::ios::out | std::ios::binary);
    for (std::uintmax_t page = 4096; page + 4096 <= size; page += 4096) {
        file.seekp(static_cast<std::streamoff>(page));
        file << std::string(64, '\xff');
    }
    file.close();
    const auto store = SqliteJobStore::open(file_);
    ASSERT_FALSE(store);
    EXPECT_EQ(store.error().code, "storage-damaged");
}

TEST_F(SqliteJobStoreTest, RefusesAFileOfANewerVersion) {
    {
        SQLite::Database db(file_.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        db.exec("PRAGMA user_version = 99");
    }
    const auto store = SqliteJobStore::open(file_);
    ASSERT_FALSE(store);
    EXPECT_EQ(store.error().code, "storage-too-new");
}

TEST_F(SqliteJobStoreTest, RefusesAFolderThatIsNotThere) {
    const auto store = SqliteJobStore::open(folder_.path() / "no" / "jobs.sqlite");
    ASSERT_FALSE(store);
    EXPECT_EQ(store.error().kind, ErrorKind::Internal);
}

TEST_F(SqliteJobStoreTest, RemovesLabelsWithTheirJob) {
    {
        auto store = SqliteJobStore::open(file_);
        ASSERT_TRUE(store);
        ASSERT_TRUE((*store)->insert(make_job(1), {"key", "body"}));
        ASSERT_TRUE((*store)->remove(id_number(1)));
    }
    SQLite::Database db(file_.string());
    EXPECT_EQ(db.execAndGet("SELECT count(*) FROM job_labels").getInt(), 0);
    EXPECT_EQ(db.execAndGet("SELECT count(*) FROM idempotency_keys").getInt(), 0);
}

}  // namespace
}  // namespace bouguer::server
