// SPDX-License-Identifier: Apache-2.0
#include "server/storage/store_gaps.h"

#include "server/log.h"
#include "server/storage/memory_job_store.h"
#include "server/storage/memory_result_store.h"
#include "tests/server/storage/job_store_contract.h"

namespace bouguer::server {
namespace {

class StoreGapsTest : public testing::Test {
  protected:
    StoreGapsTest() { set_log_level(LogLevel::Error); }
    void add(int n, JobState state, bool has_results) {
        Job job = make_job(n);
        job.state = state;
        ASSERT_TRUE(jobs_.insert(job, {}));
        if (has_results) add_results(n);
    }
    void add_results(int n) { ASSERT_TRUE(results_.put(id_number(n), {{"image.png", "x"}})); }

    MemoryJobStore jobs_;
    MemoryResultStore results_;
};

// Everything that a crash at any moment can leave.
TEST_F(StoreGapsTest, ThereAreNoneAfterACrash) {
    add(1, JobState::Done, true);
    add(2, JobState::Running, true);  // between the results and the end
    add(3, JobState::Queued, true);
    add(4, JobState::Queued, false);
    add(5, JobState::Cancelled, false);
    add(6, JobState::Failed, false);
    EXPECT_TRUE(find_gaps(jobs_, results_)->empty());
    EXPECT_TRUE(settle_stores(jobs_, results_, false));
}

TEST_F(StoreGapsTest, ARemovalThatACrashInterruptedIsFinished) {
    add(1, JobState::Done, true);
    ASSERT_TRUE(jobs_.remove(id_number(1)));
    ASSERT_TRUE(settle_stores(jobs_, results_, false));
    EXPECT_TRUE(results_.names(id_number(1))->empty());
    EXPECT_TRUE(jobs_.removed()->empty());
}

TEST_F(StoreGapsTest, ResultsOfUnknownJobsAreNotPassedOver) {
    add(1, JobState::Done, true);
    add_results(2);
    add_results(3);
    const auto refused = settle_stores(jobs_, results_, false);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, "storage-incomplete");
    EXPECT_NE(refused.error().message.find("results of 2 jobs"), std::string::npos);
    EXPECT_NE(refused.error().message.find("--accept-loss"), std::string::npos);
    EXPECT_FALSE(results_.names(id_number(2))->empty()) << "nothing is touched";
    ASSERT_TRUE(settle_stores(jobs_, results_, true));
    EXPECT_TRUE(settle_stores(jobs_, results_, false)) << "what was accepted is not asked again";
    EXPECT_FALSE(results_.names(id_number(1))->empty());
}

TEST_F(StoreGapsTest, FinishedJobsWithoutResultsAreNotPassedOver) {
    add(1, JobState::Done, false);
    EXPECT_EQ(find_gaps(jobs_, results_)->results_lost, std::vector<JobId>{id_number(1)});
    EXPECT_FALSE(settle_stores(jobs_, results_, false));
    EXPECT_TRUE(settle_stores(jobs_, results_, true));
    EXPECT_TRUE(jobs_.find(id_number(1))) << "the job itself is kept";
}

}  // namespace
}  // namespace bouguer::server
