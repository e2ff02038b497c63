// SPDX-License-Identifier: Apache-2.0
// The short form of the calibration: the claims command does it at full length.
#include "tests/accuracy/claims.h"

#include <gtest/gtest.h>

#include "tests/support/scene_files.h"
#include "tests/support/source_folder.h"

namespace bouguer::test {
namespace {

// Figure 4(d) at 40 x 30: claimed over true error within [0.9, 1.1]. The truth is the root mean
// square over 12 seeds, 1200 pixels and 3 channels, which spreads by about 1 %.
TEST(ClaimedError, IsTheTrueErrorOfFigure4d) {
    auto job = load_job(tests::source_folder() / "client-examples/scenes/lee/figure-4d.json");
    job.settings.resolution = {40, 30};
    ClaimSettings claims;
    claims.seeds = 12;
    claims.samples = 16;
    const auto rows =
        compare_claims(renderer::build_scene(job.scene).value(), job.settings, claims);
    ASSERT_EQ(rows.size(), 2U);
    for (const auto& [samples, row] : rows) {
        EXPECT_GT(row.truth, 0) << samples;
        EXPECT_NEAR(row.ratio(), 1, 0.1)
            << samples << " samples: claimed " << row.claimed << ", true " << row.truth;
    }
}

}  // namespace
}  // namespace bouguer::test
