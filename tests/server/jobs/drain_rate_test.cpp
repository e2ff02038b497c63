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
    EXPECT_EQ(timed.seconds(), 1) << "there is nothing to wait for";
    timed.begin(1000);
    EXPECT_EQ(timed.seconds(), DrainRate::kUnmeasured_s);
}

// A queue of 50 that nothing has left in 8 s once made clients wait for 375 s.
TEST(DrainRate, DoesNotGuessFromWhatHasNotEnded) {
    Timed timed;
    timed.begin(50);
    for (const auto passed : {8s, 60s, 600s}) {
        timed.now += passed;
        EXPECT_EQ(timed.seconds(), DrainRate::kUnmeasured_s);
    }
    timed.end(2, 1s);
    EXPECT_EQ(timed.seconds(), DrainRate::kUnmeasured_s) << "two are no measure";
}

TEST(DrainRate, MeasuresFromTheThirdEndOn) {
    Timed timed;
    timed.begin(53);
    timed.end(3, 1s);
    EXPECT_NEAR(timed.seconds(), 50, 2) << "50 jobs at one a second";
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

// The queue was empty for a day: the rate is still that of the work.
TEST(DrainRate, IdleTimeIsNoSlowness) {
    Timed timed;
    timed.begin(100);
    timed.end(100, 1s);
    timed.now += 24h;
    timed.begin(20);
    EXPECT_NEAR(timed.seconds(), 20, 1);
    timed.now += 8s;
    EXPECT_NEAR(timed.seconds(), 23, 1) << "the measure of before does not vanish";
}

TEST(DrainRate, AJobThatDoesNotEndCountsToo) {
    Timed timed;
    timed.begin(5);
    timed.end(3, 1ms);
    EXPECT_EQ(timed.seconds(), 1);
    timed.now += 60s;
    // 60 (1 - 1/e) = 37.9 s of weighted time, 3/e = 1.10 ends, two jobs: 68.7 s
    EXPECT_EQ(timed.seconds(), 69);
}

TEST(DrainRate, StaysInItsBounds) {
    Timed timed;
    timed.begin(100'000);
    timed.end(10, 30s);
    EXPECT_EQ(timed.seconds(), 120);
    Timed fast;
    fast.begin(10);
    fast.end(10, 1ms);
    EXPECT_EQ(fast.seconds(), 1);
    fast.end(3, 1ms);  // more ends than begins: nothing to wait for
    EXPECT_EQ(fast.seconds(), 1);
}

}  // namespace
}  // namespace bouguer::server
