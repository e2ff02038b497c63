// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/drain_rate.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

using namespace std::chrono_literals;

/// A rate and the time, which the test lets pass.
struct Timed {
    DrainRate rate;
    DrainRate::Clock::time_point now{std::chrono::hours(1)};

    void begin(int jobs) {
        for (int i = 0; i < jobs; ++i) rate.begin(now);
    }
    /// So many ends, each after `each`.
    void end(int jobs, std::chrono::milliseconds each) {
        for (int i = 0; i < jobs; ++i) {
            now += each;
            rate.end(now);
        }
    }
    [[nodiscard]] int seconds() const { return rate.seconds_to_drain(now); }
};

TEST(DrainRate, KnowsNothingAtFirst) {
    Timed timed;
    EXPECT_EQ(timed.seconds(), 1);
    timed.begin(1000);
    EXPECT_EQ(timed.seconds(), 1) << "nothing was measured yet";
}

TEST(DrainRate, FollowsWhatWasMeasured) {
    Timed timed;
    timed.begin(1100);
    timed.end(1000, 100ms);  // ten a second for 100 s
    EXPECT_NEAR(timed.seconds(), 10, 1) << "100 jobs at ten a second";
    timed.end(90, 100ms);
    EXPECT_NEAR(timed.seconds(), 1, 1);
}

TEST(DrainRate, ForgetsTheTimeBefore) {
    Timed timed;
    timed.begin(3500);
    timed.end(3000, 10ms);  // a hundred a second for 30 s,
    EXPECT_NEAR(timed.seconds(), 5, 1);
    // Then one a second for seven minutes: of what was before, 6000 (1 - e^-0.5) e^-7 = 2 ends
    // still count, beside 60 new ones. So 80 jobs take 80 x 60 / 62 s.
    timed.end(420, 1000ms);
    EXPECT_NEAR(timed.seconds(), 77, 2);
}

// The queue was empty for an hour: the rate is still that of the work.
TEST(DrainRate, IdleTimeIsNoSlowness) {
    Timed timed;
    timed.begin(100);
    timed.end(100, 1s);
    timed.now += 30s;
    timed.begin(20);
    EXPECT_NEAR(timed.seconds(), 20, 1);
}

TEST(DrainRate, AJobThatDoesNotEndCountsToo) {
    Timed timed;
    timed.begin(2);
    timed.now += 10s;
    // integral of exp(-t/60) over 10 s: 60 (1 - exp(-1/6)) = 9.21; two jobs of at least that
    EXPECT_EQ(timed.seconds(), 19);
}

TEST(DrainRate, StaysInItsBounds) {
    Timed timed;
    timed.begin(100'000);
    timed.end(10, 30s);
    EXPECT_EQ(timed.seconds(), 600);
    Timed fast;
    fast.begin(10);
    fast.end(10, 1ms);
    EXPECT_EQ(fast.seconds(), 1);
    fast.end(3, 1ms);  // more ends than begins: nothing to wait for
    EXPECT_EQ(fast.seconds(), 1);
}

}  // namespace
}  // namespace bouguer::server
