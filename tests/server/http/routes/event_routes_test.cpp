// SPDX-License-Identifier: Apache-2.0
#include <thread>

#include "tests/server/http/server_fixture.h"

namespace bouguer::server::testing {
namespace {

using std::chrono::milliseconds;
using EventRoutesTest = ServerTest;

/// Waits, two seconds at most.
template <class Condition>
bool eventually(Condition condition) {
    for (int i = 0; i < 400 && !condition(); ++i) std::this_thread::sleep_for(milliseconds(5));
    return condition();
}

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t n = 0;
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
    return n;
}

TEST_F(EventRoutesTest, SnapshotFirstDoneLastThenTheEnd) {
    start();
    const JobId id = jobs.add();
    RawClient client = connect();
    client.send(request_text("GET", path_of(id, "/events"), {"Last-Event-ID: 17"}));
    std::string text = client.receive_until("snapshot");
    EXPECT_EQ(text.rfind("HTTP/1.1 200 OK\r\n", 0), 0U) << text;
    EXPECT_NE(text.find("Content-Type: text/event-stream"), std::string::npos);
    EXPECT_EQ(text.find("Content-Length"), std::string::npos);
    EXPECT_NE(text.find("Connection: close"), std::string::npos);
    jobs.emit(id, "preview", R"({"revision":2})");
    EXPECT_NE(client.receive_until("\"revision\":2}\n\n").find("event: preview\n"),
              std::string::npos);
    jobs.finish(id);
    EXPECT_NE(client.receive_until("done\"}\n\n").find("event: done\n"), std::string::npos);
    EXPECT_TRUE(client.is_closed());
    EXPECT_TRUE(eventually([&] { return jobs.listeners() == 0 && server().connections() == 0; }));
    ASSERT_EQ(log().size(), 1U);
    EXPECT_EQ(log()[0].status, 200);
    EXPECT_GT(log()[0].bytes, 100U);
}

TEST_F(EventRoutesTest, AnEndedJobGivesSnapshotAndDone) {
    start();
    const JobId id = jobs.add();
    jobs.finish(id);
    RawClient client = connect();
    client.send(request_text("GET", path_of(id, "/events")));
    const std::string text = client.receive_until("event: done");
    EXPECT_LT(text.find("event: snapshot"), text.find("event: done"));
    EXPECT_TRUE(client.is_closed());
}

TEST_F(EventRoutesTest, WhoWasToldTheEndIsToldToComeNoMore) {
    start();
    const JobId id = jobs.add();
    jobs.finish(id);
    RawClient client = connect();
    client.send(request_text("GET", path_of(id, "/events")));
    EXPECT_NE(client.receive_until("event: done").find("id: done\nevent: done"), std::string::npos);
    const auto again = ask("GET", path_of(id, "/events"), {"Last-Event-ID: done"});
    EXPECT_EQ(again.status, 204);
    EXPECT_EQ(again.body, "");
    EXPECT_EQ(jobs.listeners(), 0U);
    EXPECT_EQ(ask("GET", path_of("01890000-0000-7000-8000-ffffffffffff", "/events"),
                  {"Last-Event-ID: done"})
                  .status,
              404);
}

TEST_F(EventRoutesTest, ANumberOfAnotherProcessIsNotTheEnd) {
    start();
    const JobId id = jobs.add();
    jobs.finish(id);
    for (const char* last_id : {"Last-Event-ID: 2", "Last-Event-ID: ", "Last-Event-ID: done1"}) {
        RawClient client = connect();
        client.send(request_text("GET", path_of(id, "/events"), {last_id}));
        EXPECT_NE(client.receive_until("event: done").find("event: snapshot"), std::string::npos);
    }
}

TEST_F(EventRoutesTest, TheWordForTheEndOfARunningJobIsNotBelieved) {
    start();
    const JobId id = jobs.add();
    RawClient client = connect();
    client.send(request_text("GET", path_of(id, "/events"), {"Last-Event-ID: done"}));
    EXPECT_NE(client.receive_until("snapshot").find("200 OK"), std::string::npos);
}

TEST_F(EventRoutesTest, SaysWhenToComeBack) {
    start();
    const JobId id = jobs.add();
    RawClient client = connect();
    client.send(request_text("GET", path_of(id, "/events")));
    EXPECT_NE(client.receive_until("snapshot").find("\r\n\r\nretry: 2000\nid: "),
              std::string::npos);
}

TEST_F(EventRoutesTest, ProgressIsThinnedOut) {
    HttpOptions options;
    options.deadlines.progress_interval = milliseconds(100);
    start(options);
    const JobId id = jobs.add();
    RawClient client = connect();
    client.send(request_text("GET", path_of(id, "/events")));
    (void)client.receive_until("snapshot");
    for (int i = 0; i < 100; ++i) {
        jobs.emit(id, "progress", std::to_string(i));
        std::this_thread::sleep_for(milliseconds(3));
    }
    jobs.finish(id);
    const std::string text = client.receive_until("event: done");
    // 100 in about a third of a second (or more, on a busy machine), one in 100 ms of them is sent
    EXPECT_GE(count(text, "event: progress"), 2U);
    EXPECT_LE(count(text, "event: progress"), 50U);
    EXPECT_NE(text.find("data: 99\n"), std::string::npos) << "the newest is never lost";
}

TEST_F(EventRoutesTest, SilenceIsBrokenByHeartbeats) {
    HttpOptions options;
    options.deadlines.heartbeat = milliseconds(60);
    start(options);
    const JobId id = jobs.add();
    RawClient client = connect();
    client.send(request_text("GET", path_of(id, "/events")));
    (void)client.receive_until("snapshot");
    EXPECT_NE(client.receive_until(":\n\n:\n\n").find(":\n\n"), std::string::npos);
}

TEST_F(EventRoutesTest, ManyStreamsDoNotStarveTheRest) {
    HttpOptions options;
    options.handler_threads = 2;
    start(options);
    const JobId id = jobs.add();
    constexpr std::size_t kStreams = 200;
    std::vector<RawClient> clients;
    for (std::size_t i = 0; i < kStreams; ++i) {
        clients.push_back(connect());
        clients.back().send(request_text("GET", path_of(id, "/events")));
    }
    ASSERT_TRUE(eventually([&] { return jobs.listeners() == kStreams; }));
    EXPECT_EQ(ask("GET", "/livez").status, 200);
    EXPECT_EQ(ask("GET", path_of(id)).status, 200);
    jobs.finish(id);
    for (RawClient& client : clients) {
        EXPECT_NE(client.receive_until("event: done").find("event: done"), std::string::npos);
    }
}

TEST_F(EventRoutesTest, AWatcherThatGoesIsForgotten) {
    start();
    const JobId id = jobs.add();
    {
        RawClient client = connect();
        client.send(request_text("GET", path_of(id, "/events")));
        (void)client.receive_until("snapshot");
        EXPECT_EQ(jobs.listeners(), 1U);
    }
    EXPECT_TRUE(eventually([&] { return jobs.listeners() == 0 && server().connections() == 0; }));
}

TEST_F(EventRoutesTest, AWatcherThatDoesNotReadIsDropped) {
    HttpOptions options;
    options.limits.event_buffer_bytes = 1U << 20U;
    start(options);
    const JobId id = jobs.add();
    const RawClient client = connect();
    client.send(request_text("GET", path_of(id, "/events")));
    ASSERT_TRUE(eventually([&] { return jobs.listeners() == 1; }));
    const std::string large(100'000, 'x');
    for (int i = 0; i < 1000 && jobs.listeners() == 1; ++i) {
        jobs.emit(id, "preview", large);
        std::this_thread::sleep_for(milliseconds(1));
    }
    EXPECT_TRUE(eventually([&] { return jobs.listeners() == 0; }));
    ASSERT_FALSE(log().empty());
    EXPECT_EQ(log().back().error, "slow event reader dropped");
    EXPECT_EQ(ask("GET", "/livez").status, 200);
}

TEST_F(EventRoutesTest, AServerThatGoesLeavesNoListener) {
    start();
    const JobId id = jobs.add();
    std::vector<RawClient> clients;
    for (int i = 0; i < 20; ++i) {
        clients.push_back(connect());
        const bool waits = i % 2 == 0;
        clients.back().send(waits ? request_text("GET", path_of(id), {"Prefer: wait=20"})
                                  : request_text("GET", path_of(id, "/events")));
    }
    ASSERT_TRUE(eventually([&] { return jobs.listeners() > 0; }));
    destroy_server();  // in the middle of it
    EXPECT_EQ(jobs.listeners(), 0U);
}

TEST_F(EventRoutesTest, DrainEndsStreams) {
    start();
    const JobId id = jobs.add();
    RawClient client = connect();
    client.send(request_text("GET", path_of(id, "/events")));
    (void)client.receive_until("snapshot");
    server().drain();
    EXPECT_TRUE(client.is_closed());
    EXPECT_EQ(server().connections(), 0U);
}

}  // namespace
}  // namespace bouguer::server::testing
