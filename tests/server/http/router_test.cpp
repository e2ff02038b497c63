// SPDX-License-Identifier: Apache-2.0
#include "server/http/router.h"

#include "tests/server/http/server_fixture.h"

namespace bouguer::server::testing {
namespace {

class RouterTest : public ServerTest {
  protected:
    void start_with_origins(std::vector<std::string> origins) {
        HttpOptions options;
        options.cors_origins = std::move(origins);
        start(options);
    }
};

TEST_F(RouterTest, EveryAnswerCarriesDateIdAndNosniff) {
    start();
    for (const char* target : {"/livez", "/v1/jobs", "/nowhere"}) {
        const auto response = ask("GET", target);
        EXPECT_FALSE(response.header("date").empty()) << target;
        EXPECT_EQ(response.header("x-request-id").size(), 16U) << target;
        EXPECT_EQ(response.header("x-content-type-options"), "nosniff") << target;
        EXPECT_EQ(response.header("keep-alive"), "") << target;
    }
}

TEST_F(RouterTest, NoOriginIsAllowedUnlessListed) {
    start();
    const auto response = ask("GET", "/v1/jobs", {"Origin: https://a.example"});
    EXPECT_EQ(response.status, 200);
    EXPECT_EQ(response.header("access-control-allow-origin"), "");
}

TEST_F(RouterTest, ListedOriginsMayReadAndAsk) {
    start_with_origins({"https://a.example", "null"});
    const auto get = ask("GET", "/v1/jobs", {"Origin: https://a.example"});
    EXPECT_EQ(get.header("access-control-allow-origin"), "https://a.example");
    EXPECT_NE(get.header("access-control-expose-headers").find("Location"), std::string::npos);
    EXPECT_EQ(get.header("vary"), "Origin");
    const auto preflight =
        ask("OPTIONS", "/v1/jobs", {"Origin: null", "Access-Control-Request-Method: POST"});
    EXPECT_EQ(preflight.status, 204);
    EXPECT_EQ(preflight.header("access-control-allow-origin"), "null");
    EXPECT_NE(preflight.header("access-control-allow-headers").find("Idempotency-Key"),
              std::string::npos);
    EXPECT_EQ(
        ask("GET", "/v1/jobs", {"Origin: https://b.example"}).header("access-control-allow-origin"),
        "");
}

// A page elsewhere can send a POST without asking first; it must not change anything.
TEST_F(RouterTest, PagesElsewhereChangeNothing) {
    start_with_origins({"https://a.example"});
    const JobId id = jobs.add();
    const auto foreign = ask("POST", path_of(id, "/cancel"), {"Origin: https://evil.example"});
    EXPECT_TRUE(is_problem(foreign, 403, "origin-not-allowed")) << foreign.body;
    EXPECT_NE(ask("GET", path_of(id)).body.find("running"), std::string::npos);
    EXPECT_EQ(ask("POST", path_of(id, "/cancel"), {"Origin: http://localhost"}).status, 200)
        << "the server's own page";
    EXPECT_EQ(ask("POST", path_of(id, "/cancel"), {"Origin: https://a.example"}).status, 200);
}

TEST_F(RouterTest, ValidationNeedsNoJob) {
    start();
    EXPECT_EQ(ask("POST", "/v1/scenes/validate", {}, "{}").status, 200);
    EXPECT_TRUE(is_problem(ask("POST", "/v1/scenes/validate"), 400, "malformed-document"));
}

}  // namespace
}  // namespace bouguer::server::testing
