// SPDX-License-Identifier: Apache-2.0
#include "server/cli/progress_bar.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

TEST(ProgressBar, SaysHowFarHowFastHowGoodAndHowLong) {
    JobProgress progress;
    progress.fraction = 0.5;
    progress.samples = 8;
    progress.rays = 3'000'000;
    progress.seconds = 2;
    progress.seconds_left = 2.4;
    progress.relative_rmse = renderer::Estimate{0.0213, 0.02, 0.0227};
    EXPECT_EQ(progress_line(progress),
              "[###############               ]  50 %  8 samples  1.50 Mrays/s  error 2.13 %  "
              "3 s left");
}

TEST(ProgressBar, LeavesOutWhatIsNotKnown) {
    EXPECT_EQ(progress_line({}), "[                              ]   0 %  0 samples");
}

}  // namespace
}  // namespace bouguer::server
