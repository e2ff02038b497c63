// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/accepted_requests.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace bouguer::server {
namespace {

api::JobRequest request_named(const std::string& digest) {
    api::JobRequest request;
    request.digest = digest;
    request.canonical = "{}";
    return request;
}

TEST(AcceptedRequests, AreTakenOnce) {
    AcceptedRequests accepted(10);
    accepted.keep("a", request_named("of a"), 5);
    accepted.keep("b", request_named("of b"), 5);
    const auto b = accepted.take("b");
    ASSERT_TRUE(b);
    EXPECT_EQ(b->digest, "of b");
    EXPECT_EQ(b->canonical, "");
    EXPECT_FALSE(accepted.take("b"));
    EXPECT_TRUE(accepted.take("a"));
    EXPECT_FALSE(accepted.take("never kept"));
}

TEST(AcceptedRequests, MakeRoomForNewerOnes) {
    AcceptedRequests accepted(10);
    accepted.keep("a", request_named("of a"), 4);
    accepted.keep("b", request_named("of b"), 4);
    accepted.keep("c", request_named("of c"), 6);
    EXPECT_FALSE(accepted.take("a"));
    EXPECT_TRUE(accepted.take("b"));
    EXPECT_TRUE(accepted.take("c"));
    accepted.keep("d", request_named("of d"), 10);  // what was taken takes no room
    EXPECT_TRUE(accepted.take("d"));
}

TEST(AcceptedRequests, DoNotMakeRoomForWhatWillNotFit) {
    AcceptedRequests accepted(10);
    accepted.keep("a", request_named("of a"), 4);
    accepted.keep("b", request_named("of b"), 11);
    EXPECT_TRUE(accepted.take("a"));
    EXPECT_FALSE(accepted.take("b"));
}

TEST(AcceptedRequests, AreForgottenWhenNobodyWillAsk) {
    AcceptedRequests accepted(10);
    accepted.keep("a", request_named("of a"), 10);
    accepted.drop("a");
    accepted.drop("a");
    EXPECT_FALSE(accepted.take("a"));
    accepted.keep("b", request_named("of b"), 10);
    EXPECT_TRUE(accepted.take("b"));
}

TEST(AcceptedRequests, GoFromManyThreadsToMany) {
    AcceptedRequests accepted(8);
    std::vector<std::thread> threads;
    for (int k = 0; k < 4; ++k) {
        threads.emplace_back([&accepted, k] {
            for (int i = 0; i < 1000; ++i) {
                const JobId id = std::to_string(k);
                accepted.keep(id, request_named(id), 1);
                const auto taken = accepted.take(id);
                ASSERT_TRUE(taken);
                EXPECT_EQ(taken->digest, id);
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace bouguer::server
