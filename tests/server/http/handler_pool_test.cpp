// SPDX-License-Identifier: Apache-2.0
#include "server/http/handler_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <semaphore>

namespace bouguer::server {
namespace {

std::unique_ptr<Exchange> request(const std::string& client, std::size_t body) {
    auto exchange = std::make_unique<Exchange>();
    exchange->client_key = client;
    exchange->body.resize(body);
    return exchange;
}

// Large documents of many clients, each of which takes as long as it likes.
TEST(HandlerPool, NothingWaitsBehindLargeDocuments) {
    std::counting_semaphore<100> go(0);
    std::counting_semaphore<100> answered(0);
    std::atomic<int> heavy{0};
    HandlerPool pool({.threads = 4, .waiting = 100, .share = 100},
                     [&](const std::unique_ptr<Exchange>& exchange) {
                         if (exchange->body.empty()) return answered.release();
                         EXPECT_LE(++heavy, 2) << "half of the threads";
                         go.acquire();
                         --heavy;
                         answered.release();
                     });
    for (int i = 0; i < 8; ++i) {
        auto large = request(std::to_string(i), kHeavyBody + 1);
        ASSERT_TRUE(pool.try_submit(large));
    }
    for (int i = 0; i < 50; ++i) {
        auto small = request("c", 0);
        ASSERT_TRUE(pool.try_submit(small));
        answered.acquire();  // while the large ones wait
    }
    go.release(8);
    for (int i = 0; i < 8; ++i) answered.acquire();
}

TEST(HandlerPool, DropsWhatWaitsWhenItStops) {
    std::atomic<int> done{0};
    HandlerPool pool({.threads = 2, .waiting = 1000, .share = 1000},
                     [&](const std::unique_ptr<Exchange>&) { ++done; });
    for (int i = 0; i < 500; ++i) {
        auto exchange = request("a", 0);
        ASSERT_TRUE(pool.try_submit(exchange));
    }
    pool.stop();
    const int before = done;
    auto late = request("a", 0);
    EXPECT_FALSE(pool.try_submit(late));
    EXPECT_EQ(done, before);
}

}  // namespace
}  // namespace bouguer::server
