// SPDX-License-Identifier: Apache-2.0
#include "server/utc_time.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

TEST(UtcTime, IsRfc3339) {
    EXPECT_EQ(utc_text(0), "1970-01-01T00:00:00.000Z");
    EXPECT_EQ(utc_text(1'700'000'000'007), "2023-11-14T22:13:20.007Z");
    EXPECT_EQ(utc_text(-1), "1969-12-31T23:59:59.999Z");
}

}  // namespace
}  // namespace bouguer::server
