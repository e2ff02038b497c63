// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/job.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

constexpr std::array kAllStates{JobState::Queued, JobState::Running, JobState::Done,
                                JobState::Failed, JobState::Cancelled};

TEST(JobState, NothingFollowsAFinalState) {
    for (const JobState from : kAllStates) {
        for (const JobState to : kAllStates) {
            if (is_final(from)) {
                EXPECT_FALSE(is_legal(from, to)) << to_string(from);
            }
        }
    }
}

TEST(JobState, EveryStateIsReachedFromQueued) {
    EXPECT_TRUE(is_legal(JobState::Queued, JobState::Running));
    EXPECT_TRUE(is_legal(JobState::Running, JobState::Done));
    EXPECT_TRUE(is_legal(JobState::Running, JobState::Queued));
    EXPECT_FALSE(is_legal(JobState::Queued, JobState::Done));
}

TEST(JobState, NamesRoundTrip) {
    for (const JobState state : kAllStates) EXPECT_EQ(job_state_from(to_string(state)), state);
    EXPECT_FALSE(job_state_from("asleep"));
}

}  // namespace
}  // namespace bouguer::server
