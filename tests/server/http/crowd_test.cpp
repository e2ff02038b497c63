// SPDX-License-Identifier: Apache-2.0
// Many connections, and what one client's leave to the others and to whoever asks about health.
#include "server/http/connection_front.h"
#include "tests/server/http/server_fixture.h"
#include "tests/server/unnamed_file.h"

namespace bouguer::server::testing {
namespace {

constexpr const char* kOther = "127.0.0.2";

class CrowdTest : public ServerTest {
  protected:
    /// A job with a file of `bytes` in a file.
    JobId job_with_file(const std::string& bytes) {
        const JobId id = jobs.add();
        const Content content(unnamed_file(bytes), 0, bytes.size());
        jobs.set_file(id, "image.exr", {content, "image/x-exr", "ee", true});
        return id;
    }
    [[nodiscard]] RawResponse ask_from(const char* source, const std::string& text) const {
        RawClient client = connect(source);
        client.send(text);
        return client.receive();
    }
    /// The status of a request for the jobs by another client.
    [[nodiscard]] int status_for_others() const {
        return ask_from(kOther, request_text("GET", "/v1/jobs")).status;
    }
};

TEST_F(CrowdTest, AFileIsSentAsItIs) {
    start();
    const std::string bytes = numbered_bytes(5 * Outgoing::kWindowBytes + 17);
    const std::string path = path_of(job_with_file(bytes), "/image.exr");
    EXPECT_EQ(ask("GET", path).body, bytes);
    const auto part = ask("GET", path, {"Range: bytes=300000-1000000"});
    EXPECT_EQ(part.status, 206);
    EXPECT_EQ(part.body, bytes.substr(300'000, 700'001));
    const auto head = ask("HEAD", path);
    EXPECT_EQ(head.header("content-length"), std::to_string(bytes.size()));
    EXPECT_EQ(ask("GET", path, {"If-None-Match: \"ee\""}).status, 304);
    RawClient client = connect();
    for (int i = 0; i < 3; ++i) {
        client.send(request_text("HEAD", path) + request_text("GET", path));
        EXPECT_EQ(client.receive(true).status, 200);
        EXPECT_EQ(client.receive().body, bytes) << "nothing follows the head of HEAD";
    }
}

TEST_F(CrowdTest, AFileThatCannotBeReadIsAnError) {
    start();
    const JobId id = jobs.add();
    jobs.set_file(id, "image.exr",
                  {Content(unnamed_file("short"), 0, 1000), "image/x-exr", "ee", true});
    EXPECT_TRUE(is_problem(ask("GET", path_of(id, "/image.exr")), 500, "storage-failed"));
    EXPECT_EQ(ask("GET", "/v1/jobs").status, 200);
}

// 8 MB each, of which the budget for all has four.
TEST_F(CrowdTest, FilesThatNobodyReadsHoldUpNobody) {
    HttpOptions options;
    options.limits.buffered_bytes = 32U << 20U;
    start(options);
    const std::string path = path_of(job_with_file(numbered_bytes(8U << 20U)), "/image.exr");
    std::vector<RawClient> silent;
    for (int i = 0; i < 20; ++i) {
        silent.push_back(connect());
        silent.back().send(request_text("GET", path));
        EXPECT_EQ(silent.back().receive(true).status, 200) << i;
    }
    EXPECT_EQ(ask("GET", "/livez").status, 200);
    EXPECT_EQ(ask("GET", "/v1/jobs").status, 200);
    EXPECT_EQ(ask("GET", path).body.size(), 8U << 20U);
}

// What was made for an answer is held as a whole: a client has a quarter of 16 MiB.
TEST_F(CrowdTest, AnswersInMemoryAreBoundedForEachClient) {
    HttpOptions options;
    options.limits.buffered_bytes = 16U << 20U;
    start(options);
    const JobId id = jobs.add();
    jobs.set_file(id, "image.exr", {std::string(3U << 20U, 'x'), "image/x-exr", "ee", true});
    const std::string get = request_text("GET", path_of(id, "/image.exr"));
    RawClient first = connect();
    first.send(get);
    EXPECT_EQ(first.receive(true).status, 200);
    EXPECT_TRUE(is_problem(ask_raw(get), 503, "busy"));
    EXPECT_EQ(ask("GET", "/v1/jobs").status, 200) << "what is small goes through";
    EXPECT_EQ(ask_from(kOther, get).body.size(), 3U << 20U);
}

TEST_F(CrowdTest, OnlyWhatHasArrivedOfABodyIsHeld) {
    HttpOptions options;
    options.limits.buffered_bytes = 400'000;
    start(options);
    std::vector<RawClient> slow;
    for (int i = 0; i < 50; ++i) {
        slow.push_back(connect());
        slow.back().send(
            "POST /v1/jobs HTTP/1.1\r\nHost: h\r\nContent-Type: application/json\r\n"
            "Expect: 100-continue\r\nContent-Length: 8000000\r\n\r\n{");
        (void)slow.back().receive_until("\r\n\r\n");  // its head was read
    }
    EXPECT_EQ(ask("POST", "/v1/jobs", {}, "{" + std::string(20'000, ' ') + "}").status, 202);
}

TEST_F(CrowdTest, BodiesAreBoundedForEachClient) {
    HttpOptions options;
    options.limits.buffered_bytes = 400'000;
    start(options);
    const std::string large = "{" + std::string(150'000, ' ') + "}";
    const std::string small = "{" + std::string(20'000, ' ') + "}";
    EXPECT_TRUE(is_problem(ask("POST", "/v1/jobs", {}, large), 503, "busy")) << "over its quarter";
    EXPECT_EQ(ask("POST", "/v1/jobs", {}, small).status, 202);
}

TEST_F(CrowdTest, HealthNeedsNoRoom) {
    HttpOptions options;
    options.limits.buffered_bytes = 1;
    options.limits.upload_bytes = 1;
    options.limits.waiting_requests = 0;
    start(options);
    EXPECT_EQ(ask("GET", "/v1/jobs").status, 503);
    EXPECT_EQ(ask("GET", "/livez").status, 200);
    EXPECT_EQ(ask("GET", "/readyz").status, 200);
}

TEST_F(CrowdTest, OneClientLeavesPlacesToOthers) {
    HttpOptions options;
    options.max_connections = 10;
    options.max_connections_per_client = 4;
    start(options);
    std::vector<RawClient> clients;
    for (int i = 0; i < 4; ++i) {
        clients.push_back(connect());
        clients.back().send(request_text("GET", "/v1/jobs"));
        EXPECT_EQ(clients.back().receive().status, 200);
    }
    EXPECT_TRUE(is_problem(ask("GET", "/v1/jobs"), 503, "busy"));
    EXPECT_EQ(ask("GET", "/livez").status, 200) << "that much is always answered";
    EXPECT_EQ(server().connections(), 4U) << "guests are not counted";
    EXPECT_EQ(status_for_others(), 200);
    clients.clear();
    RawResponse response;
    for (int i = 0; i < 200 && response.status != 200; ++i) response = ask("GET", "/v1/jobs");
    EXPECT_EQ(response.status, 200);
}

TEST_F(CrowdTest, HealthIsAnsweredWhenAllPlacesAreTaken) {
    HttpOptions options;
    options.max_connections = 3;
    start(options);
    std::vector<RawClient> silent;
    for (int i = 0; i < 3; ++i) {
        silent.push_back(connect());
        silent.back().send(request_text("GET", "/livez"));
        EXPECT_EQ(silent.back().receive().status, 200);
    }
    // more than there are places for health as well, and none of them says a word
    for (int i = 0; i < 200; ++i) silent.push_back(connect());
    for (int i = 0; i < 20; ++i) {
        RawClient client = connect();
        client.send(request_text("GET", "/livez"));
        const auto response = client.receive();
        EXPECT_EQ(response.status, 200);
        EXPECT_EQ(response.header("connection"), "close") << "the place is for the next";
    }
    EXPECT_TRUE(is_problem(ask("POST", "/v1/jobs", {}, "{}"), 503, "busy"));
    EXPECT_EQ(server().connections(), 3U);
}

TEST_F(CrowdTest, AGuestThatSaysNothingIsSentAway) {
    HttpOptions options;
    options.max_connections = 1;
    options.deadlines.reserved_place = std::chrono::milliseconds(50);
    start(options);
    RawClient first = connect();
    first.send(request_text("GET", "/livez"));
    EXPECT_EQ(first.receive().status, 200);
    RawClient guest = connect();
    EXPECT_TRUE(is_problem(guest.receive(), 503, "busy"));
    EXPECT_TRUE(guest.is_closed());
}

TEST_F(CrowdTest, TheDoorForHealthHasNothingElse) {
    HttpOptions options;
    options.max_connections = 1;
    options.health = HealthAddress{"127.0.0.1", 0};
    start(options);
    RawClient only = connect();
    only.send(request_text("GET", "/livez"));
    EXPECT_EQ(only.receive().status, 200);
    ASSERT_GT(server().health_port(), 0);
    EXPECT_NE(server().health_port(), server().port());
    RawClient client(server().health_port());
    for (const char* path : {"/livez", "/readyz", "/livez"}) {
        client.send(request_text("GET", path));
        EXPECT_EQ(client.receive().status, 200) << path;
    }
    client.send(request_text("GET", "/v1/jobs"));
    EXPECT_TRUE(is_problem(client.receive(), 404, "not-found"));
    EXPECT_TRUE(client.is_closed());
    RawClient posting(server().health_port());
    posting.send(request_text("POST", "/v1/jobs", {}, "{}"));
    EXPECT_EQ(posting.receive().status, 404);
    EXPECT_EQ(server().connections(), 1U);
}

TEST_F(CrowdTest, TheDoorForHealthStaysOpenToTheEnd) {
    HttpOptions options;
    options.health = HealthAddress{"127.0.0.1", 0};
    start(options);
    RawClient client(server().health_port());
    client.send(request_text("GET", "/livez"));
    EXPECT_EQ(client.receive().status, 200);
    jobs.is_ready = false;
    server().drain();
    client.send(request_text("GET", "/readyz"));
    EXPECT_EQ(client.receive().status, 503);
    RawClient late(server().health_port());
    late.send(request_text("GET", "/readyz"));
    EXPECT_EQ(late.receive().status, 503);
}

// The log is written by the front's own thread here.
TEST_F(CrowdTest, MemoryThatRunsOutCostsOneConnection) {
    std::atomic<bool> is_out{true};
    HttpOptions options;
    options.port = 0;
    options.allowed_hosts = {{"localhost", std::nullopt}};
    const auto server = HttpServer::start(jobs, assets, options, [&](const AccessRecord&) {
        if (is_out) throw std::bad_alloc();
    });
    ASSERT_TRUE(server);
    RawClient unlucky((*server)->port());
    unlucky.send(request_text("GET", "/livez"));
    EXPECT_TRUE(unlucky.is_closed());
    is_out = false;
    RawClient next((*server)->port());
    next.send(request_text("GET", "/livez"));
    EXPECT_EQ(next.receive().status, 200);
}

}  // namespace
}  // namespace bouguer::server::testing
