// SPDX-License-Identifier: Apache-2.0
#include "server/http/connection_plan.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

HttpOptions asking_for(std::size_t connections, std::size_t of_a_client = 0) {
    HttpOptions options;
    options.max_connections = connections;
    options.max_connections_per_client = of_a_client;
    return options;
}

TEST(ConnectionPlan, GivesAClientAQuarter) {
    const ConnectionPlan plan = plan_connections({}, 1'000'000);
    EXPECT_EQ(plan.connections, 16'384U);
    EXPECT_EQ(plan.share, 4'096U);
    EXPECT_EQ(plan.health_places, 64U);
    EXPECT_FALSE(plan.is_cut);
    EXPECT_EQ(plan.share_of(1000), 250U);
    EXPECT_EQ(plan.share_of(3), 1U);
}

TEST(ConnectionPlan, AClientThatMayHaveAllConnectionsMayHaveAllMemory) {
    EXPECT_EQ(plan_connections(asking_for(100, 50), 10'000).share_of(1000), 500U);
    EXPECT_EQ(plan_connections(asking_for(100, 1'000), 10'000).share_of(1000), 1000U);
    EXPECT_EQ(plan_connections(asking_for(100, 1), 10'000).share_of(1000), 250U);
    EXPECT_EQ(plan_connections(asking_for(3), 10'000).share, 3U) << "a quarter of 3 is no service";
}

// Two descriptors a connection, two kinds of places for health, and what the rest needs.
TEST(ConnectionPlan, NeverNeedsMoreDescriptorsThanThereAre) {
    for (const std::size_t limit : {64U, 100U, 256U, 1024U, 4096U, 1U << 20U}) {
        const ConnectionPlan plan = plan_connections(asking_for(1'000'000), limit);
        const std::size_t reserve = std::min<std::size_t>(128, limit / 2);
        EXPECT_LE(2 * plan.connections + 2 * plan.health_places + reserve, limit) << limit;
        EXPECT_GE(plan.connections, limit / 8) << limit;
        EXPECT_TRUE(plan.is_cut);
    }
    const ConnectionPlan none = plan_connections({}, 0);
    EXPECT_GE(none.connections, 1U);
    EXPECT_GE(none.health_places, 1U);
}

}  // namespace
}  // namespace bouguer::server
