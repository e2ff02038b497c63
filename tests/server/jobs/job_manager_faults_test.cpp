// SPDX-License-Identifier: Apache-2.0
// What the jobs do while the storage fails: wait and are stored when it is well again.
#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <thread>
#include <utility>

#include "server/jobs/job_manager.h"
#include "server/log.h"
#include "tests/server/jobs/faulty_stores.h"
#include "tests/server/jobs/small_job.h"
#include "tests/server/jobs/wait_until.h"
#include "tests/support/named_bytes.h"

namespace bouguer::server {
namespace {

using namespace std::chrono_literals;

class JobManagerFaults : public testing::Test {
  protected:
    JobManagerFaults() {
        set_log_level(LogLevel::Error);
        start();
    }
    void start() {
        JobManagerOptions options{.threads = 2};
        options.storage_times = {20ms, 1ms, 10ms};
        options.accepted_bytes = 0;  // so that every request is read from the store
        options.check_storage = [this]() -> Result<void> {
            if (place_.strikes()) return place_.error();
            return {};
        };
        manager_ = std::make_unique<JobManager>(jobs_, results_, assets_, options);
        ASSERT_TRUE(manager_->start());
    }
    JobId submit(const std::string& body = small_job()) {
        auto submitted = manager_->submit(body, "");
        EXPECT_TRUE(submitted) << submitted.error().message;
        return submitted ? submitted->view.job.id : "";
    }
    JobState state_of(const JobId& id) { return manager_->find(id)->job.state; }
    void wait_for(const JobId& id, JobState state) {
        wait_until([&] { return state_of(id) == state; });
    }
    void wait_until_ready() {
        wait_until([&] { return manager_->readiness().ready; });
    }

    FaultyJobStore jobs_;
    FaultyResultStore results_;
    Fault place_;
    tests::NoAssets assets_;
    std::unique_ptr<JobManager> manager_;
};

TEST_F(JobManagerFaults, AFinishedRenderIsKeptUntilItsFilesCanBeStored) {
    results_.puts.is_on = true;
    const JobId id = submit();
    wait_until([&] { return results_.puts.refused > 3; });
    EXPECT_EQ(state_of(id), JobState::Running);
    EXPECT_EQ(manager_->readiness().reason, "storage-full");
    const auto kept = manager_->file(id, "image.png");
    ASSERT_TRUE(kept) << "the picture can be had meanwhile";
    EXPECT_FALSE(kept->final);
    results_.puts.is_on = false;
    wait_for(id, JobState::Done);
    EXPECT_EQ(manager_->file(id, "image.png")->digest, kept->digest);
    EXPECT_TRUE(manager_->file(id, "image.png")->final);
    wait_until_ready();
}

TEST_F(JobManagerFaults, AnEndIsStoredAndToldWhenTheStoreWorksAgain) {
    jobs_.ends.is_on = true;
    const JobId id = submit();
    std::mutex mutex;
    std::string types;
    const auto subscription = manager_->subscribe(id, [&](const JobEvent& event) {
        const std::lock_guard lock(mutex);
        types += event.type + " ";
    });
    wait_until([&] { return jobs_.ends.refused > 3; });
    {
        const std::lock_guard lock(mutex);
        EXPECT_EQ(types.find("done"), std::string::npos) << "it is told when it is stored";
    }
    jobs_.ends.is_on = false;
    wait_for(id, JobState::Done);
    wait_until([&] {
        const std::lock_guard lock(mutex);
        return types.find("done ") != std::string::npos;
    });
}

TEST_F(JobManagerFaults, AJobThatCannotBeMarkedAsBegunWaitsAndIsRendered) {
    jobs_.begins.is_on = true;
    const JobId id = submit();
    wait_until([&] { return jobs_.begins.refused > 0; });
    EXPECT_EQ(state_of(id), JobState::Queued);
    jobs_.begins.is_on = false;
    wait_for(id, JobState::Done);
    EXPECT_EQ(manager_->find(id)->job.attempts, 1U);
}

// As when there are no descriptors left: the job is not at fault, and waits.
TEST_F(JobManagerFaults, AJobWhoseRequestCannotBeReadWaitsAndIsRendered) {
    jobs_.reads.is_on = true;
    const JobId id = submit();
    wait_until([&] { return jobs_.reads.refused > 3; });
    EXPECT_FALSE(is_final(state_of(id)));
    jobs_.reads.is_on = false;
    wait_for(id, JobState::Done);
    EXPECT_EQ(manager_->find(id)->job.attempts, 1U)
        << "the begins that came to nothing do not count";
}

TEST_F(JobManagerFaults, AStorageThatDoesNotAnswerIsNotReady) {
    std::promise<void> answer;
    std::promise<void> asked;
    StorageWatch watch(
        [&, answered = answer.get_future().share(), first = true]() mutable -> Result<void> {
            if (std::exchange(first, false)) asked.set_value();
            answered.wait();
            return {};
        },
        []() -> Result<void> { return {}; }, {1ms, 1ms, 1ms, 1ms});
    watch.start();
    asked.get_future().wait();
    wait_until([&] { return watch.error().has_value(); });
    answer.set_value();
    wait_until([&] { return !watch.error().has_value(); });
}

// Every second write fails: one that goes well is no reason to say that all is well.
TEST_F(JobManagerFaults, OneGoodProbeAfterAFailureIsNotEnough) {
    std::atomic<int> probes = 0;
    std::atomic<bool> is_bad = true;
    StorageWatch watch(
        [&]() -> Result<void> {
            if (++probes % 2 == 0 && is_bad) {
                return fail(ErrorKind::Internal, "EIO", "storage-failed");
            }
            return {};
        },
        []() -> Result<void> { return {}; }, {1ms, 1ms, 1ms});
    watch.report({ErrorKind::Internal, "EIO", {}, "storage-failed"});
    watch.start();
    while (probes < 40) EXPECT_TRUE(watch.error().has_value()) << probes;
    is_bad = false;
    wait_until([&] { return !watch.error().has_value(); });
}

// One call in so many fails, as with a disk that is about to die: whatever was accepted ends.
TEST_F(JobManagerFaults, ScatteredFaultsLoseNothing) {
    std::vector<JobId> ids;
    for (int i = 0; i < 40; ++i) {
        results_.puts.left = i % 3;
        jobs_.begins.left = (i + 1) % 2;
        jobs_.ends.left = i % 4;
        wait_until([&] {
            auto submitted = manager_->submit(small_job(1), "");
            if (submitted) ids.push_back(submitted->view.job.id);
            return submitted.has_value();
        });
    }
    for (const JobId& id : ids) wait_for(id, JobState::Done);
    EXPECT_EQ(manager_->queue_length(), 0U);
}

TEST_F(JobManagerFaults, NothingIsTakenOrBegunDuringAFault) {
    results_.puts.is_on = true;
    const JobId first = submit();
    wait_until([&] { return results_.puts.refused > 0; });
    const auto refused = manager_->submit(small_job(), "");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, "storage-full");
    results_.puts.is_on = false;
    wait_for(first, JobState::Done);
    wait_until_ready();
    wait_for(submit(), JobState::Done);
}

TEST_F(JobManagerFaults, ASubmitThatCannotBeStoredIsRefusedAndLeavesNothing) {
    jobs_.inserts.left = 1;
    const auto refused = manager_->submit(small_job(), "key");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, "storage-full");
    EXPECT_TRUE(manager_->list(10, "", std::nullopt)->jobs.empty());
    wait_until_ready();
    const auto again = manager_->submit(small_job(), "key");
    ASSERT_TRUE(again);
    EXPECT_FALSE(again->replayed);
}

TEST_F(JobManagerFaults, ReadinessFollowsTheProbeAndThePlace) {
    EXPECT_TRUE(manager_->readiness().ready);
    for (Fault* fault : {&jobs_.probes, &place_}) {
        fault->is_on = true;
        wait_until([&] { return !manager_->readiness().ready; });
        EXPECT_EQ(manager_->readiness().reason, "storage-full");
        fault->is_on = false;
        wait_until_ready();
    }
}

TEST_F(JobManagerFaults, CancelDuringAFaultIsRefusedOrHolds) {
    jobs_.ends.is_on = true;
    const JobId id = submit(endless_job());
    wait_until([&] { return !manager_->find(id)->images.empty(); });
    EXPECT_EQ(manager_->cancel(id).error().code, "storage-full");
    EXPECT_EQ(state_of(id), JobState::Running);
    jobs_.ends.is_on = false;
    ASSERT_TRUE(manager_->cancel(id));
    EXPECT_EQ(state_of(id), JobState::Cancelled);
}

TEST_F(JobManagerFaults, AJobThatEndedAndIsNotStoredCanBeRemoved) {
    results_.puts.is_on = true;
    const JobId id = submit();
    wait_until([&] { return results_.puts.refused > 0; });
    ASSERT_TRUE(manager_->remove(id));
    EXPECT_EQ(manager_->find(id).error().kind, ErrorKind::NotFound);
    results_.puts.is_on = false;
    wait_until_ready();
    EXPECT_TRUE(results_.names(id)->empty()) << "what was kept must go too";
}

// Stopping does not wait for a disk that may never come back; the next process renders it again.
TEST_F(JobManagerFaults, StopsDuringAFaultAndTheNextProcessEndsTheJob) {
    results_.puts.is_on = true;
    const JobId id = submit();
    wait_until([&] { return results_.puts.refused > 0; });
    manager_->stop();
    EXPECT_EQ(jobs_.find(id)->state, JobState::Queued);
    results_.puts.is_on = false;
    start();
    wait_for(id, JobState::Done);
}

TEST_F(JobManagerFaults, StartsOnAStoreThatCannotWriteAndGoesOnLater) {
    const JobId id = submit(endless_job());
    wait_for(id, JobState::Running);
    jobs_.ends.is_on = true;  // also the way back into the queue
    manager_.reset();
    EXPECT_EQ(jobs_.find(id)->state, JobState::Running);
    start();
    EXPECT_EQ(state_of(id), JobState::Running);
    jobs_.ends.is_on = false;
    wait_until([&] { return !manager_->find(id)->images.empty(); });
}

}  // namespace
}  // namespace bouguer::server
