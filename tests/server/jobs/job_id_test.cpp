// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/job_id.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace bouguer::server {
namespace {

// RFC 9562, appendix A.6: 0x017F22E279B0 ms, version 7, variant 10.
TEST(JobId, HasTheLayoutOfVersion7) {
    JobIdMaker maker;
    const JobId id = maker.make(0x017F22E279B0);
    EXPECT_TRUE(is_job_id(id)) << id;
    EXPECT_EQ(id.substr(0, 15), "017f22e2-79b0-7");
    EXPECT_NE(std::string("89ab").find(id[19]), std::string::npos) << id;
}

// More than fit into one millisecond's counter, and a clock that is set back.
TEST(JobId, SortsByTimeOfMaking) {
    JobIdMaker maker;
    std::vector<JobId> ids;
    for (int i = 0; i < 10'000; ++i) ids.push_back(maker.make(1000));
    ids.push_back(maker.make(500));
    ids.push_back(maker.make(2000));
    EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
    EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
}

TEST(JobId, IsRecognised) {
    EXPECT_TRUE(is_job_id("017f22e2-79b0-7cc3-98c4-dc0c0c07398f"));
    for (const char* bad :
         {"", "017f22e2", "017F22E2-79B0-7CC3-98C4-DC0C0C07398F",
          "017f22e2-79b0-7cc3-98c4-dc0c0c07398", "017f22e2-79b0-7cc3-98c4-dc0c0c07398f0",
          "017f22e2x79b0-7cc3-98c4-dc0c0c07398f", "../../../../../../../../../../passwd"}) {
        EXPECT_FALSE(is_job_id(bad)) << bad;
    }
}

}  // namespace
}  // namespace bouguer::server
