// SPDX-License-Identifier: Apache-2.0
#include "server/http/image_work.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

// Each turn is taken inside another, as by as many threads.
TEST(ImageWork, RefusesMoreThanItHasTurns) {
    ImageWork work;
    const auto make = [] { return Result<int>(1); };
    for (int round = 0; round < 2; ++round) {
        const auto outer = work.run([&] {
            EXPECT_TRUE(work.run(make)) << "two at once";
            return work.run([&] { return work.run(make); });
        });
        ASSERT_FALSE(outer);
        EXPECT_EQ(outer.error().kind, ErrorKind::Busy);
        EXPECT_EQ(outer.error().code, "images-busy");
    }
    EXPECT_TRUE(work.run(make));
}

}  // namespace
}  // namespace bouguer::server
