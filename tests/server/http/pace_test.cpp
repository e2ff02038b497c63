// SPDX-License-Identifier: Apache-2.0
#include "server/http/pace.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Pace::Terms kTerms{.first = seconds(3), .most = seconds(10), .bytes_per_second = 1000};
const Pace::Clock::time_point kBegin{};

TEST(Pace, GivesSomeTimeToBeginWith) {
    EXPECT_EQ(Pace(kTerms, kBegin).deadline(), kBegin + seconds(3));
}

TEST(Pace, EveryByteBuysItsTime) {
    Pace pace(kTerms, kBegin);
    pace.progress(500, kBegin + milliseconds(100));
    EXPECT_EQ(pace.deadline(), kBegin + milliseconds(3500));
    pace.progress(0, kBegin + milliseconds(200));
    EXPECT_EQ(pace.deadline(), kBegin + milliseconds(3500));
}

TEST(Pace, NoMoreThanSoMuchIsSaved) {
    Pace pace(kTerms, kBegin);
    pace.progress(1'000'000, kBegin + seconds(1));
    EXPECT_EQ(pace.deadline(), kBegin + seconds(11));
}

// One byte every two seconds, of 1000 that are due each second.
TEST(Pace, DribletsDoNotProlongIt) {
    Pace pace(kTerms, kBegin);
    auto now = kBegin;
    while (now < pace.deadline()) {
        now += seconds(2);
        pace.progress(1, now);
    }
    EXPECT_EQ(now, kBegin + seconds(4));
}

TEST(Pace, TheLeastRateIsEnoughForEver) {
    Pace pace(kTerms, kBegin);
    for (int s = 1; s < 10'000; ++s) {
        pace.progress(1000, kBegin + seconds(s));
        ASSERT_GE(pace.deadline(), kBegin + seconds(s + 3)) << s;
    }
}

TEST(Pace, TimeThatWeTookIsForgiven) {
    Pace pace(kTerms, kBegin);
    pace.forgive(seconds(5));
    EXPECT_EQ(pace.deadline(), kBegin + seconds(8));
}

}  // namespace
}  // namespace bouguer::server
