// SPDX-License-Identifier: Apache-2.0
// What every JobStore must do. A backend joins with INSTANTIATE_TYPED_TEST_SUITE_P and a small
// struct: `std::unique_ptr<JobStore> make()`, and `kDurable` with `reopen()` when it keeps what it
// was told.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <thread>

#include "server/storage/job_store.h"

namespace bouguer::server {

/// Id number `n`; later numbers sort later.
inline JobId id_number(int n) {
    std::string tail = std::to_string(n);
    return "01890a5d-ac96-774b-bcce-" + std::string(12 - tail.size(), '0') + tail;
}

inline Job make_job(int n) {
    Job job;
    job.id = id_number(n);
    job.priority = -3;
    job.created_ms = 1'700'000'000'000 + n;
    job.memory_bytes = 5'000'000'000;
    job.name = "amber ball \xE2\x98\x83 'quoted'; --";
    // A NUL ends no text: documents may have it as \u0000, in names too.
    job.name += std::string("\0after a NUL", 12);
    job.labels = {{"customer", "A & B"},
                  {"empty", ""},
                  {std::string("nul\0a", 5), std::string("\0value", 6)},
                  {std::string("nul\0b", 5), "other"}};
    job.scene_digest = "sha256-aa";
    job.digest = "sha256-bb";
    job.request = R"({"format":"bouguer-job/1"})";
    return job;
}

/// What comes out of a store: all but the document.
inline Job stored(Job job) {
    job.request.clear();
    return job;
}

template <class Backend>
class JobStoreContract : public testing::Test {
  protected:
    Backend backend_;
    std::unique_ptr<JobStore> store_ = backend_.make();

    void insert(const Job& job, const IdempotencyKey& key = {}) {
        ASSERT_TRUE(store_->insert(job, key));
    }
};
TYPED_TEST_SUITE_P(JobStoreContract);

TYPED_TEST_P(JobStoreContract, GivesBackWhatWasInserted) {
    const Job job = make_job(1);
    const auto inserted = this->store_->insert(job, {});
    ASSERT_TRUE(inserted);
    EXPECT_FALSE(inserted->replayed);
    EXPECT_EQ(inserted->job, stored(job));
    EXPECT_EQ(this->store_->find(job.id).value(), stored(job));
    EXPECT_EQ(this->store_->request(job.id).value(), job.request);
    EXPECT_TRUE(this->store_->probe());
}

TYPED_TEST_P(JobStoreContract, RefusesAnIdTwice) {
    this->insert(make_job(1));
    EXPECT_EQ(this->store_->insert(make_job(1), {}).error().kind, ErrorKind::Conflict);
}

TYPED_TEST_P(JobStoreContract, KnowsNothingOfUnknownJobs) {
    const JobId id = id_number(7);
    EXPECT_EQ(this->store_->find(id).error().kind, ErrorKind::NotFound);
    EXPECT_EQ(this->store_->request(id).error().kind, ErrorKind::NotFound);
    EXPECT_EQ(this->store_->remove(id).error().kind, ErrorKind::NotFound);
    EXPECT_EQ(this->store_->transition(id, {JobState::Queued, JobState::Running, 1}).error().kind,
              ErrorKind::NotFound);
}

TYPED_TEST_P(JobStoreContract, ReplaysAKeyWithTheSameBody) {
    this->insert(make_job(1), {"key", "body-1"});
    const auto again = this->store_->insert(make_job(2), {"key", "body-1"});
    ASSERT_TRUE(again);
    EXPECT_TRUE(again->replayed);
    EXPECT_EQ(again->job.id, id_number(1));
    EXPECT_FALSE(this->store_->find(id_number(2))) << "the second job must not be stored";
    const auto found = this->store_->find_key({"key", "body-1"});
    ASSERT_TRUE(found && *found);
    EXPECT_EQ((*found)->job.id, id_number(1));
}

TYPED_TEST_P(JobStoreContract, RefusesAKeyWithAnotherBody) {
    this->insert(make_job(1), {"key", "body-1"});
    const auto other = this->store_->insert(make_job(2), {"key", "body-2"});
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().kind, ErrorKind::InvalidInput);
    EXPECT_EQ(other.error().code, "idempotency-key-reused");
    EXPECT_FALSE(this->store_->find(id_number(2)));
    EXPECT_EQ(this->store_->find_key({"key", "body-2"}).error().code, "idempotency-key-reused");
}

TYPED_TEST_P(JobStoreContract, ForgetsTheKeyWithItsJob) {
    this->insert(make_job(1), {"key", "body-1"});
    ASSERT_TRUE(this->store_->remove(id_number(1)));
    EXPECT_FALSE(this->store_->find(id_number(1)));
    const auto key = this->store_->find_key({"key", "body-2"});
    ASSERT_TRUE(key);
    EXPECT_FALSE(*key);
    this->insert(make_job(2), {"key", "body-2"});
}

TYPED_TEST_P(JobStoreContract, JobsWithoutAKeyAreAllNew) {
    this->insert(make_job(1));
    const auto second = this->store_->insert(make_job(2), {});
    ASSERT_TRUE(second);
    EXPECT_FALSE(second->replayed);
}

TYPED_TEST_P(JobStoreContract, ListsNewestFirstPageByPage) {
    for (int n = 1; n <= 5; ++n) this->insert(make_job(n));
    std::vector<JobId> ids;
    std::string cursor;
    int pages = 0;
    do {
        const auto page = this->store_->list(2, cursor, std::nullopt);
        ASSERT_TRUE(page);
        for (const Job& job : page->jobs) ids.push_back(job.id);
        cursor = page->next_cursor;
        ++pages;
        // A job that comes while one reads does not disturb the pages.
        if (pages == 1) this->insert(make_job(9));
    } while (!cursor.empty());
    EXPECT_EQ(pages, 3);
    EXPECT_EQ(ids, (std::vector<JobId>{id_number(5), id_number(4), id_number(3), id_number(2),
                                       id_number(1)}));
}

TYPED_TEST_P(JobStoreContract, AFullLastPageHasNoCursor) {
    for (int n = 1; n <= 4; ++n) this->insert(make_job(n));
    const auto first = this->store_->list(2, "", std::nullopt);
    ASSERT_TRUE(first);
    const auto last = this->store_->list(2, first->next_cursor, std::nullopt);
    ASSERT_TRUE(last);
    EXPECT_EQ(last->jobs.size(), 2U);
    EXPECT_EQ(last->next_cursor, "");
}

TYPED_TEST_P(JobStoreContract, ListsByState) {
    for (int n = 1; n <= 3; ++n) this->insert(make_job(n));
    ASSERT_TRUE(this->store_->transition(id_number(2), {JobState::Queued, JobState::Cancelled, 5}));
    const auto queued = this->store_->list(10, "", JobState::Queued);
    ASSERT_TRUE(queued);
    ASSERT_EQ(queued->jobs.size(), 2U);
    EXPECT_EQ(queued->jobs[0].id, id_number(3));
    const auto cancelled = this->store_->list(10, "", JobState::Cancelled);
    ASSERT_TRUE(cancelled);
    ASSERT_EQ(cancelled->jobs.size(), 1U);
}

TYPED_TEST_P(JobStoreContract, RefusesForeignCursors) {
    for (const std::string cursor : {"x", "' OR 1=1 --", "01890A5D-AC96-774B-BCCE-000000000001"}) {
        const auto page = this->store_->list(2, cursor, std::nullopt);
        ASSERT_FALSE(page) << cursor;
        EXPECT_EQ(page.error().code, "bad-cursor");
    }
}

TYPED_TEST_P(JobStoreContract, TransitionsSetTimesAndRevision) {
    this->insert(make_job(1));
    const auto running =
        this->store_->transition(id_number(1), {JobState::Queued, JobState::Running, 50});
    ASSERT_TRUE(running);
    EXPECT_EQ(running->state, JobState::Running);
    EXPECT_EQ(running->started_ms, 50);
    EXPECT_EQ(running->revision, 2U);
    const JobProgress progress{0.5,
                               8,
                               3,
                               1'000'000'000'000,
                               1.25,
                               {},
                               renderer::Estimate{0.01, 0.009, 0.0125},
                               renderer::Estimate{0.1, 0.09, 0.125}};
    const auto failed = this->store_->transition(
        id_number(1), {JobState::Running, JobState::Failed, 60, "no light", progress});
    ASSERT_TRUE(failed);
    EXPECT_EQ(failed->ended_ms, 60);
    EXPECT_EQ(failed->failure, "no light");
    EXPECT_EQ(failed->progress, progress);
    EXPECT_EQ(failed->revision, 3U);
    EXPECT_EQ(this->store_->find(id_number(1)).value(), *failed);
}

TYPED_TEST_P(JobStoreContract, ARestartTakesTheStartBack) {
    this->insert(make_job(1));
    ASSERT_TRUE(this->store_->transition(id_number(1), {JobState::Queued, JobState::Running, 50}));
    const auto queued =
        this->store_->transition(id_number(1), {JobState::Running, JobState::Queued, 60});
    ASSERT_TRUE(queued);
    EXPECT_EQ(queued->started_ms, 0);
    EXPECT_EQ(queued->ended_ms, 0);
}

TYPED_TEST_P(JobStoreContract, CountsBeginsThatNoOrderlyStopEnded) {
    this->insert(make_job(1));
    const auto change = [&](JobState from, JobState to, bool takes_begin_back = false) {
        Transition transition{from, to, 50};
        transition.takes_begin_back = takes_begin_back;
        return this->store_->transition(id_number(1), transition)->attempts;
    };
    EXPECT_EQ(change(JobState::Queued, JobState::Running), 1U);
    EXPECT_EQ(change(JobState::Running, JobState::Queued), 1U) << "what a crash left";
    EXPECT_EQ(change(JobState::Queued, JobState::Running), 2U);
    EXPECT_EQ(change(JobState::Running, JobState::Queued, true), 1U) << "an orderly stop";
    EXPECT_EQ(change(JobState::Queued, JobState::Running), 2U);
    EXPECT_EQ(this->store_->find(id_number(1))->attempts, 2U);
    EXPECT_EQ(this->store_->unfinished()->at(0).attempts, 2U);
}

TYPED_TEST_P(JobStoreContract, KeepsTheCodeOfAFailure) {
    this->insert(make_job(1));
    Transition failed{JobState::Queued, JobState::Failed, 60, "no light"};
    failed.failure_code = "too-dark";
    ASSERT_TRUE(this->store_->transition(id_number(1), failed));
    EXPECT_EQ(this->store_->find(id_number(1))->failure_code, "too-dark");
}

TYPED_TEST_P(JobStoreContract, RemembersWhatWasRemovedUntilToldOtherwise) {
    this->insert(make_job(1));
    this->insert(make_job(2));
    ASSERT_TRUE(this->store_->remove(id_number(1)));
    EXPECT_FALSE(this->store_->remove(id_number(1)));
    EXPECT_EQ(this->store_->removed().value(), std::vector<JobId>{id_number(1)});
    ASSERT_TRUE(this->store_->forget_removed());
    EXPECT_TRUE(this->store_->removed()->empty());
}

TYPED_TEST_P(JobStoreContract, TellsTheStateOfEveryJob) {
    this->insert(make_job(1));
    this->insert(make_job(2));
    ASSERT_TRUE(this->store_->transition(id_number(2), {JobState::Queued, JobState::Running, 5}));
    auto states = this->store_->states().value();
    std::sort(states.begin(), states.end());
    EXPECT_EQ(states, (std::vector<std::pair<JobId, JobState>>{{id_number(1), JobState::Queued},
                                                               {id_number(2), JobState::Running}}));
}

// Every pair of states: only the table's transitions happen, and only from the state that is named.
TYPED_TEST_P(JobStoreContract, RefusesWhatTheTableDoesNotAllow) {
    constexpr std::array kStates{JobState::Queued, JobState::Running, JobState::Done,
                                 JobState::Failed, JobState::Cancelled};
    int n = 0;
    for (const JobState from : kStates) {
        for (const JobState to : kStates) {
            Job job = make_job(++n);
            job.state = from;
            this->insert(job);
            const auto changed = this->store_->transition(job.id, {from, to, 1});
            EXPECT_EQ(changed.has_value(), is_legal(from, to))
                << to_string(from) << " -> " << to_string(to);
            if (!changed) {
                EXPECT_EQ(changed.error().kind, ErrorKind::Conflict);
                EXPECT_EQ(this->store_->find(job.id).value(), stored(job));
            }
        }
    }
    this->insert(make_job(100));
    EXPECT_EQ(this->store_->transition(id_number(100), {JobState::Running, JobState::Done, 1})
                  .error()
                  .kind,
              ErrorKind::Conflict);
}

// Of many threads that want the same transition exactly one gets it.
TYPED_TEST_P(JobStoreContract, TransitionsAreAtomic) {
    constexpr int kJobs = 10;
    for (int n = 0; n < kJobs; ++n) this->insert(make_job(n));
    std::atomic<int> winners = 0;
    {
        std::vector<std::jthread> threads;
        for (int t = 0; t < 4; ++t) {
            threads.emplace_back([&] {
                for (int n = 0; n < kJobs; ++n) {
                    if (this->store_->transition(id_number(n),
                                                 {JobState::Queued, JobState::Running, 1})) {
                        ++winners;
                    }
                }
            });
        }
    }
    EXPECT_EQ(winners, kJobs);
}

TYPED_TEST_P(JobStoreContract, FindsUnfinishedJobsOldestFirst) {
    constexpr std::array kStates{JobState::Running, JobState::Done, JobState::Queued,
                                 JobState::Failed, JobState::Cancelled};
    for (std::size_t i = 0; i < kStates.size(); ++i) {
        Job job = make_job(static_cast<int>(i));
        job.state = kStates.at(i);
        this->insert(job);
    }
    const auto jobs = this->store_->unfinished();
    ASSERT_TRUE(jobs);
    ASSERT_EQ(jobs->size(), 2U);
    EXPECT_EQ((*jobs)[0].id, id_number(0));
    EXPECT_EQ((*jobs)[0].labels, make_job(0).labels);
    EXPECT_EQ((*jobs)[1].id, id_number(2));
}

REGISTER_TYPED_TEST_SUITE_P(JobStoreContract, GivesBackWhatWasInserted, RefusesAnIdTwice,
                            KnowsNothingOfUnknownJobs, ReplaysAKeyWithTheSameBody,
                            RefusesAKeyWithAnotherBody, ForgetsTheKeyWithItsJob,
                            JobsWithoutAKeyAreAllNew, ListsNewestFirstPageByPage,
                            AFullLastPageHasNoCursor, ListsByState, RefusesForeignCursors,
                            TransitionsSetTimesAndRevision, ARestartTakesTheStartBack,
                            CountsBeginsThatNoOrderlyStopEnded, KeepsTheCodeOfAFailure,
                            RemembersWhatWasRemovedUntilToldOtherwise, TellsTheStateOfEveryJob,
                            RefusesWhatTheTableDoesNotAllow, TransitionsAreAtomic,
                            FindsUnfinishedJobsOldestFirst);

}  // namespace bouguer::server
