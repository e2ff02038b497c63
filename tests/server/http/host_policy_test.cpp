// SPDX-License-Identifier: Apache-2.0
#include "server/http/host_policy.h"

#include <gtest/gtest.h>

#include "tests/server/http/server_fixture.h"

namespace bouguer::server::testing {
namespace {

bool allows(const HostPolicy& policy, std::string_view host) {
    const auto authority = authority_from(host);
    EXPECT_TRUE(authority) << host;
    return authority && policy.allows(*authority);
}

TEST(HostPolicy, OnLoopbackGoesByLoopbackNamesAndItsPort) {
    const HostPolicy policy("127.0.0.1", 8080, {});
    for (const char* host :
         {"localhost:8080", "LocalHost:8080", "127.0.0.1:8080", "127.1.2.3:8080", "[::1]:8080"}) {
        EXPECT_TRUE(allows(policy, host)) << host;
    }
    for (const char* host : {"localhost", "localhost:80", "127.0.0.1:8081", "evil.example:8080",
                             "localhost.evil.example:8080", "10.0.0.1:8080", "[::2]:8080"}) {
        EXPECT_FALSE(allows(policy, host)) << host;
    }
}

TEST(HostPolicy, APortLeftOutIs80) {
    EXPECT_TRUE(allows({"127.0.0.1", 80, {}}, "localhost"));
    EXPECT_TRUE(allows({"::1", 80, {}}, "127.0.0.1"));
    EXPECT_FALSE(allows({"127.0.0.1", 443, {}}, "localhost"));
}

// A container's port is published under any other one, and addresses are no names of pages
// elsewhere.
TEST(HostPolicy, ForOthersGoesByEveryAddressAndPort) {
    const HostPolicy policy("0.0.0.0", 8080, {});
    for (const char* host : {"localhost", "localhost:9000", "127.0.0.1:8080", "10.0.0.1:9000",
                             "[fe80::1]:8080", "192.168.1.2"}) {
        EXPECT_TRUE(allows(policy, host)) << host;
    }
    EXPECT_FALSE(allows(policy, "evil.example:8080"));
    EXPECT_FALSE(allows(policy, "render"));
    EXPECT_TRUE(allows({"Render.Example", 8080, {}}, "render.example:8080")) << "listens on it";
}

TEST(HostPolicy, GoesByWhatIsAllowed) {
    const HostPolicy policy("127.0.0.1", 8080,
                            {{"render.example", std::nullopt}, {"proxy.example", 443}});
    EXPECT_TRUE(allows(policy, "render.example"));
    EXPECT_TRUE(allows(policy, "render.example:1234"));
    EXPECT_TRUE(allows(policy, "proxy.example")) << "443 is left out behind https";
    EXPECT_TRUE(allows(policy, "proxy.example:443"));
    EXPECT_FALSE(allows(policy, "proxy.example:8443"));
    EXPECT_FALSE(allows(policy, "a.render.example"));
    EXPECT_TRUE(allows(policy, "localhost:8080")) << "still";
}

class HostPolicyTest : public ServerTest {
  protected:
    void start_for(std::vector<Authority> hosts) {
        HttpOptions options;
        options.allowed_hosts = std::move(hosts);
        start(options);
    }
    [[nodiscard]] RawResponse ask_as(const std::string& host, const std::string& request) const {
        const std::string port = std::to_string(server().port());
        std::string text = request;
        for (auto at = text.find("PORT"); at != std::string::npos; at = text.find("PORT")) {
            text.replace(at, 4, port);
        }
        return ask_raw(text + "Host: " + host + (host.ends_with(':') ? port : "") + "\r\n\r\n");
    }
};

// DNS rebinding: the page's name leads here, so Host and Origin agree, and the browser sees nothing
// wrong.
TEST_F(HostPolicyTest, WhoeverIsDeceivedGetsNothing) {
    start_for({{"render.example", std::nullopt}});
    const JobId id = jobs.add();
    const std::vector<std::string> paths{"/",       "/v1/jobs", "/livez",
                                         "/readyz", "/nowhere", path_of(id)};
    for (const std::string& path : paths) {
        const auto answer = ask_as("evil.example:", "GET " + path + " HTTP/1.1\r\n");
        EXPECT_TRUE(is_problem(answer, 421, "misdirected-request")) << path << answer.body;
    }
    const auto deleted =
        ask_as("evil.example:",
               "DELETE /v1/jobs/" + id + " HTTP/1.1\r\nOrigin: http://evil.example:PORT\r\n");
    EXPECT_EQ(deleted.status, 421);
    EXPECT_TRUE(jobs.find(id)) << "it is still there";
    EXPECT_EQ(ask_as("localhost:", "GET /v1/jobs HTTP/1.1\r\n").status, 200);
    EXPECT_EQ(ask_as("127.0.0.1:", "GET /livez HTTP/1.1\r\n").status, 200);
    EXPECT_EQ(ask_as("localhost", "GET /livez HTTP/1.1\r\n").status, 421) << "that is port 80";
    EXPECT_EQ(ask_as("", "GET /livez HTTP/1.1\r\n").status, 421) << "nobody";
    EXPECT_EQ(ask_as("Render.example", "GET /livez HTTP/1.1\r\n").status, 200);
    EXPECT_EQ(ask_raw("GET /livez HTTP/1.0\r\n\r\n").status, 200) << "no browser asks so";
}

// RFC 9112 §3.2.2: the host of an absolute target counts, whatever Host says.
TEST_F(HostPolicyTest, TheHostOfAnAbsoluteTargetCounts) {
    start_for({{"render.example", std::nullopt}});
    EXPECT_EQ(ask_as("localhost:", "GET http://evil.example:PORT/livez HTTP/1.1\r\n").status, 421);
    EXPECT_EQ(ask_as("evil.example:", "GET HTTP://localhost:PORT/livez HTTP/1.1\r\n").status, 200);
    EXPECT_EQ(ask_as("evil.example:", "GET http://render.example/v1/jobs HTTP/1.1\r\n").status,
              200);
    const JobId id = jobs.add();
    EXPECT_TRUE(
        is_problem(ask_as("evil.example", "DELETE http://render.example/v1/jobs/" + id +
                                              " HTTP/1.1\r\nOrigin: http://evil.example\r\n"),
                   403, "origin-not-allowed"))
        << "the origin is compared with it, too";
}

TEST_F(HostPolicyTest, NoBodyIsReadForOthers) {
    start_for({{"render.example", std::nullopt}});
    const auto answer = ask_raw(
        "POST /v1/jobs HTTP/1.1\r\nHost: evil.example\r\nContent-Length: 1000\r\n"
        "Expect: 100-continue\r\nContent-Type: application/json\r\n\r\n");
    EXPECT_EQ(answer.status, 421) << "and not 100";
}

}  // namespace
}  // namespace bouguer::server::testing
