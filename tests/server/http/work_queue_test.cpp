// SPDX-License-Identifier: Apache-2.0
#include "server/http/work_queue.h"

#include <gtest/gtest.h>

namespace bouguer::server {
namespace {

constexpr WorkQueue::Limits kLimits{.threads = 4, .waiting = 100, .share = 50};

std::unique_ptr<Exchange> request(const std::string& client, std::size_t body,
                                  std::uint64_t name = 0) {
    auto exchange = std::make_unique<Exchange>();
    exchange->client_key = client;
    exchange->body.resize(body);
    exchange->connection = name;
    return exchange;
}

bool push(WorkQueue& queue, const std::string& client, std::size_t body, std::uint64_t name = 0) {
    auto exchange = request(client, body, name);
    return queue.push(exchange);
}

TEST(WorkQueue, ClientsTakeTurns) {
    WorkQueue queue(kLimits);
    for (std::uint64_t i = 0; i < 10; ++i) ASSERT_TRUE(push(queue, "greedy", 0, i));
    ASSERT_TRUE(push(queue, "modest", 0, 100));
    EXPECT_EQ(queue.begin().exchange->connection, 0U);
    EXPECT_EQ(queue.begin().exchange->connection, 100U) << "not behind the other nine";
    EXPECT_EQ(queue.begin().exchange->connection, 1U) << "of one client in order";
}

TEST(WorkQueue, HeavyRequestsHaveHalfOfTheThreads) {
    WorkQueue queue(kLimits);
    for (const char* client : {"a", "b", "c"}) ASSERT_TRUE(push(queue, client, kHeavyBody + 1));
    const WorkQueue::Work first = queue.begin();
    ASSERT_TRUE(first.exchange);
    ASSERT_TRUE(queue.begin().exchange);
    EXPECT_FALSE(queue.begin().exchange) << "two of four threads";
    ASSERT_TRUE(push(queue, "a", 0));
    EXPECT_TRUE(queue.begin().exchange) << "what has no body waits for none of them";
    queue.end(first);
    EXPECT_EQ(queue.begin().client, "c");
}

TEST(WorkQueue, OneHeavyRequestOfAClientAtATime) {
    WorkQueue queue(kLimits);
    ASSERT_TRUE(push(queue, "a", kHeavyBody + 1));
    ASSERT_TRUE(push(queue, "a", kHeavyBody + 1));
    ASSERT_TRUE(push(queue, "b", kHeavyBody + 1));
    const WorkQueue::Work first = queue.begin();
    EXPECT_EQ(first.client, "a");
    EXPECT_EQ(queue.begin().client, "b");
    EXPECT_FALSE(queue.begin().exchange);
    queue.end(first);
    EXPECT_EQ(queue.begin().client, "a");
}

TEST(WorkQueue, DocumentsLeaveOneThreadToTheRest) {
    WorkQueue queue(kLimits);
    for (int i = 0; i < 8; ++i) ASSERT_TRUE(push(queue, "a", 100));
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(queue.begin().exchange);
    EXPECT_FALSE(queue.begin().exchange);
    ASSERT_TRUE(push(queue, "b", 0));
    EXPECT_TRUE(queue.begin().exchange);
}

TEST(WorkQueue, OneThreadDoesEverything) {
    WorkQueue queue({.threads = 1, .waiting = 10, .share = 10});
    for (const std::size_t body : {std::size_t{0}, std::size_t{10}, kHeavyBody + 1}) {
        ASSERT_TRUE(push(queue, "a", body));
    }
    for (int i = 0; i < 3; ++i) {
        const WorkQueue::Work work = queue.begin();
        ASSERT_TRUE(work.exchange) << i;
        queue.end(work);
    }
}

TEST(WorkQueue, IsBoundedForAClientAndForAll) {
    WorkQueue queue({.threads = 1, .waiting = 3, .share = 2});
    EXPECT_TRUE(push(queue, "a", 0));
    EXPECT_TRUE(push(queue, "a", 10)) << "counted together";
    auto refused = request("a", 0);
    EXPECT_FALSE(queue.push(refused));
    EXPECT_TRUE(refused) << "stays with the caller";
    EXPECT_TRUE(push(queue, "b", 0));
    EXPECT_FALSE(push(queue, "c", 0));
    ASSERT_TRUE(queue.begin().exchange);
    EXPECT_TRUE(push(queue, "c", 0)) << "what was begun waits no more";
}

}  // namespace
}  // namespace bouguer::server
