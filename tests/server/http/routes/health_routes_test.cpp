// SPDX-License-Identifier: Apache-2.0
#include <future>

#include "tests/server/http/server_fixture.h"

namespace bouguer::server::testing {
namespace {

using HealthRoutesTest = ServerTest;

TEST_F(HealthRoutesTest, SayWhetherJobsAreTaken) {
    start();
    EXPECT_EQ(ask("GET", "/livez").status, 200);
    EXPECT_EQ(ask("GET", "/readyz").body, "{\"status\":\"ready\",\"queued\":3}\n");
    EXPECT_EQ(ask("HEAD", "/readyz").header("content-length"), "30");
    jobs.is_ready = false;
    const RawResponse refused = ask("GET", "/readyz");
    EXPECT_EQ(refused.status, 503);
    EXPECT_EQ(refused.body,
              "{\"status\":\"not ready\",\"reason\":\"storage-full\",\"queued\":3}\n");
    EXPECT_EQ(ask("GET", "/livez").status, 200);
}

// Every handler thread is held up and the queue is full: the rest is turned away, health answers.
TEST_F(HealthRoutesTest, AnswerWhenNothingElseDoes) {
    HttpOptions options;
    options.handler_threads = 1;
    options.limits.waiting_requests = 1;
    start(options);
    const JobId id = jobs.add();
    std::promise<void> entered;
    std::promise<void> release;
    std::atomic<bool> first{true};
    jobs.on_find([&, released = release.get_future().share()] {
        if (first.exchange(false)) entered.set_value();
        released.wait();
    });
    RawClient working = connect();
    working.send(request_text("GET", path_of(id)));
    entered.get_future().wait();
    RawClient queued = connect();
    queued.send(request_text("GET", path_of(id)));
    RawResponse turned_away;
    while (turned_away.status != 503) turned_away = ask("GET", "/v1/jobs");
    EXPECT_TRUE(is_problem(turned_away, 503, "busy"));
    EXPECT_FALSE(turned_away.header("retry-after").empty());
    EXPECT_EQ(ask("GET", "/livez").status, 200);
    EXPECT_EQ(ask("GET", "/readyz").status, 200);
    release.set_value();
    EXPECT_EQ(working.receive().status, 200);
    EXPECT_EQ(queued.receive().status, 200);
}

}  // namespace
}  // namespace bouguer::server::testing
