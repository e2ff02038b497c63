// SPDX-License-Identifier: Apache-2.0
// Clients that are slow, broken or hostile, each over a socket of its own.
#include "server/http/connection_front.h"

#include <thread>

#include "tests/server/http/server_fixture.h"

namespace bouguer::server::testing {
namespace {

using std::chrono::milliseconds;
using ConnectionFrontTest = ServerTest;

std::string numbered(std::string prefix, int i) { return prefix.append(std::to_string(i)); }

std::string filled(std::string prefix, std::size_t n) { return prefix.append(n, 'x'); }

HttpOptions impatient() {
    HttpOptions options;
    options.deadlines.head = milliseconds(250);
    options.deadlines.idle = milliseconds(250);
    options.deadlines.body = milliseconds(250);
    options.deadlines.body_pause = milliseconds(250);
    options.deadlines.answer_pause = milliseconds(250);
    options.deadlines.linger = milliseconds(100);
    return options;
}

TEST_F(ConnectionFrontTest, AHeadByDribletsIsCutAtTheDeadline) {
    start(impatient());
    RawClient client = connect();
    const auto begin = std::chrono::steady_clock::now();
    std::atomic<bool> answered{false};
    std::thread dribble([&] {
        while (!answered) {
            client.send("G");  // each byte in time, all of them too late
            std::this_thread::sleep_for(milliseconds(10));
        }
    });
    const auto response = client.receive();
    const auto spent = std::chrono::steady_clock::now() - begin;
    answered = true;
    dribble.join();
    EXPECT_TRUE(is_problem(response, 408, "request-timeout")) << response.body;
    EXPECT_GE(spent, milliseconds(240)) << "not before its time";
    EXPECT_TRUE(client.is_closed());
}

TEST_F(ConnectionFrontTest, ASlowBodyIsCutAndAnIdleConnectionClosed) {
    start(impatient());
    RawClient slow = connect();
    slow.send("POST /v1/jobs HTTP/1.1\r\nHost: h\r\nContent-Length: 100\r\n\r\n{");
    EXPECT_EQ(slow.receive().status, 408);
    RawClient idle = connect();
    EXPECT_TRUE(idle.is_closed());
    RawClient between = connect();
    between.send(request_text("GET", "/livez"));
    EXPECT_EQ(between.receive().status, 200);
    EXPECT_TRUE(between.is_closed());
}

TEST_F(ConnectionFrontTest, AnAnswerThatIsNotReadIsCut) {
    HttpOptions options = impatient();
    options.deadlines.bytes_per_second = 1U << 30U;
    start(options);
    const JobId id = jobs.add();
    jobs.set_file(id, "image.exr", {std::string(32U << 20U, 'x'), "image/x-exr", "ee", true});
    const RawClient client = connect();
    client.send(request_text("GET", path_of(id, "/image.exr")));
    for (int i = 0; i < 400 && (i < 20 || server().connections() > 0); ++i) {
        std::this_thread::sleep_for(milliseconds(5));
    }
    EXPECT_EQ(server().connections(), 0U);
}

TEST_F(ConnectionFrontTest, AHeadOverItsLimitIs431) {
    start();
    const auto with_end = ask("GET", "/livez", {filled("X: ", 17 * 1024)});
    EXPECT_TRUE(is_problem(with_end, 431, "head-too-large")) << with_end.body;
    EXPECT_EQ(with_end.header("connection"), "close");
    const std::string endless = "GET /livez HTTP/1.1\r\nHost: h\r\nX: ";
    EXPECT_EQ(ask_raw(filled(endless, 17 * 1024)).status, 431) << "without an end";
}

TEST_F(ConnectionFrontTest, ALongPathIs414) {
    start();
    const auto response = ask("GET", filled("/", 10'000));
    EXPECT_TRUE(is_problem(response, 414, "target-too-long")) << response.body;
    EXPECT_EQ(ask("GET", filled("/", 50'000)).status, 414) << "longer than a head may be at all";
    EXPECT_EQ(ask_raw(filled("GET /", 20'000)).status, 414) << "without an end";
    EXPECT_EQ(ask("GET", filled("/v1/jobs/", 2000)).status, 404);
}

TEST_F(ConnectionFrontTest, LargeBodiesAreRefusedUnread) {
    HttpOptions options;
    options.limits.body_bytes = 1000;
    start(options);
    RawClient announced = connect();
    announced.send("POST /v1/jobs HTTP/1.1\r\nHost: h\r\nContent-Length: 1001\r\n\r\n");
    const auto response = announced.receive();  // not a byte of the body was sent
    EXPECT_TRUE(is_problem(response, 413, "content-too-large")) << response.body;
    EXPECT_TRUE(announced.is_closed());
    const std::string head =
        "POST /v1/jobs HTTP/1.1\r\nHost: h\r\nContent-Type: application/json\r\n"
        "Transfer-Encoding: chunked\r\n\r\n";
    const std::string half = "1F4\r\n{" + std::string(499, ' ') + "\r\n";
    EXPECT_EQ(ask_raw(head + half + half + "0\r\n\r\n").status, 202);
    EXPECT_EQ(jobs.last_body.size(), 1000U);
    EXPECT_EQ(ask_raw(head + half + half + "1\r\n").status, 413);
}

TEST_F(ConnectionFrontTest, TwoLengthsAreRefusedAndTheRestIsNotARequest) {
    start();
    RawClient client = connect();
    client.send(
        "POST /v1/jobs HTTP/1.1\r\nHost: h\r\nContent-Length: 6\r\nTransfer-Encoding: "
        "chunked\r\n\r\n"
        "0\r\n\r\nGET /livez HTTP/1.1\r\nHost: h\r\n\r\n");
    EXPECT_TRUE(is_problem(client.receive(), 400, "ambiguous-length"));
    EXPECT_EQ(client.receive().status, 0) << "the smuggled request was answered";
    EXPECT_TRUE(jobs.last_body.empty());
}

TEST_F(ConnectionFrontTest, ABodyIsNeverTheNextRequest) {
    start();
    const std::string smuggled = "GET /livez HTTP/1.1\r\nHost: h\r\n\r\n";
    RawClient client = connect();
    // refused by a route that does not look at the body, which is another request
    client.send(request_text("POST", "/nowhere", {}, smuggled));
    EXPECT_EQ(client.receive().status, 404);
    client.send(request_text("GET", "/v1/jobs"));
    EXPECT_NE(client.receive().body.find("\"jobs\""), std::string::npos);
}

TEST_F(ConnectionFrontTest, PipelinedRequestsAreAnsweredInOrder) {
    start();
    RawClient client = connect();
    std::string all;
    for (int i = 0; i < 50; ++i) {
        all += request_text("GET", i % 2 == 0 ? "/livez" : "/v1/jobs",
                            {numbered("X-Request-Id: r", i)});
        all += request_text("POST", "/v1/jobs", {numbered("X-Request-Id: p", i)}, "{}");
    }
    client.send(all);
    for (int i = 0; i < 50; ++i) {
        EXPECT_EQ(client.receive().header("x-request-id"), numbered("r", i));
        EXPECT_EQ(client.receive().header("x-request-id"), numbered("p", i));
    }
}

TEST_F(ConnectionFrontTest, BytesMayComeOneByOne) {
    start();
    RawClient client = connect();
    for (const char c : request_text("POST", "/v1/jobs", {}, R"({"a":2})")) {
        client.send(std::string_view(&c, 1));
    }
    EXPECT_EQ(client.receive().status, 202);
    EXPECT_EQ(jobs.last_body, R"({"a":2})");
}

TEST_F(ConnectionFrontTest, ExpectedContinueIsSentBeforeTheBody) {
    start();
    RawClient client = connect();
    client.send(
        "POST /v1/jobs HTTP/1.1\r\nHost: h\r\nContent-Type: application/json\r\n"
        "Expect: 100-continue\r\nContent-Length: 2\r\n\r\n");
    EXPECT_EQ(client.receive_until("\r\n\r\n"), "HTTP/1.1 100 Continue\r\n\r\n");
    client.send("{}");
    EXPECT_EQ(client.receive().status, 202);
}

TEST_F(ConnectionFrontTest, OldAndClosingClientsAreClosed) {
    start();
    RawClient old = connect();
    old.send("GET /livez HTTP/1.0\r\n\r\n");
    EXPECT_EQ(old.receive().header("connection"), "close");
    EXPECT_TRUE(old.is_closed());
    RawClient closing = connect();
    closing.send(request_text("GET", "/v1/jobs", {"Connection: close"}));
    closing.finish_sending();
    EXPECT_EQ(closing.receive().header("connection"), "close");
    EXPECT_TRUE(closing.is_closed());
}

TEST_F(ConnectionFrontTest, NoClientIsBelievedWhereItComesFrom) {
    start();
    EXPECT_EQ(ask("GET", "/v1/jobs", {"REMOTE_ADDR: 6.6.6.6", "X-Request-Id: evil id"}).status,
              200);
    ASSERT_EQ(log().size(), 1U);
    EXPECT_EQ(log()[0].client, "127.0.0.1");
    EXPECT_EQ(log()[0].path, "/v1/jobs");
    EXPECT_EQ(log()[0].method, "GET");
    EXPECT_EQ(log()[0].request_id.size(), 16U) << "an id with a space is replaced";
    EXPECT_GT(log()[0].bytes, 100U);
}

TEST_F(ConnectionFrontTest, RefusalsAreLoggedToo) {
    start();
    EXPECT_EQ(ask_raw("nonsense\r\n\r\n").status, 400);
    ASSERT_EQ(log().size(), 1U);
    EXPECT_EQ(log()[0].status, 400);
    EXPECT_EQ(log()[0].method, "-");
}

TEST_F(ConnectionFrontTest, DrainFinishesWhatIsUnderWay) {
    start();
    const JobId id = jobs.add();
    std::atomic<bool> entered{false};
    jobs.on_find([&] {
        entered = true;
        std::this_thread::sleep_for(milliseconds(100));
    });
    RawClient idle = connect();
    idle.send(request_text("GET", "/livez"));
    EXPECT_EQ(idle.receive().status, 200);
    RawClient working = connect();
    working.send(request_text("GET", path_of(id)));
    while (!entered) std::this_thread::yield();
    const int port = server().port();
    server().drain();
    EXPECT_EQ(working.receive().status, 200);
    EXPECT_TRUE(idle.is_closed());
    EXPECT_EQ(server().connections(), 0U);
    EXPECT_LT(RawClient(port).fd(), 0) << "the port is closed";
}

TEST_F(ConnectionFrontTest, TwoServersDoNotShareAPort) {
    start();
    HttpOptions options;
    options.port = server().port();
    const auto second = HttpServer::start(jobs, assets, options, {});
    ASSERT_FALSE(second);
    EXPECT_NE(second.error().message.find(std::to_string(options.port)), std::string::npos);
}

}  // namespace
}  // namespace bouguer::server::testing
