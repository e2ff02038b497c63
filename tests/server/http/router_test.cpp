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

TEST_F(RouterTest, AStarLetsEveryPageReadAndNoneChange) {
    start_with_origins({"*"});
    const JobId id = jobs.add();
    const std::string page = "Origin: https://any.example";
    EXPECT_EQ(ask("GET", path_of(id), {page}).header("access-control-allow-origin"),
              "https://any.example");
    EXPECT_TRUE(is_problem(ask("DELETE", path_of(id), {page}), 403, "origin-not-allowed"));
    EXPECT_EQ(ask("OPTIONS", path_of(id), {page}).header("access-control-allow-methods"),
              "GET, HEAD");
    EXPECT_TRUE(jobs.find(id));
}

TEST_F(RouterTest, ListedPagesMaySendAndReadWhatTheServiceKnows) {
    start_with_origins({"https://a.example"});
    const auto preflight = ask("OPTIONS", "/v1/jobs", {"Origin: https://a.example"});
    for (const char* name : {"Content-Type", "Idempotency-Key", "If-Match", "If-None-Match",
                             "If-Range", "Last-Event-ID", "Prefer", "Range", "X-Request-Id"}) {
        EXPECT_NE(preflight.header("access-control-allow-headers").find(name), std::string::npos)
            << name;
    }
    const auto get = ask("GET", "/v1/jobs", {"Origin: https://a.example"});
    for (const char* name : {"Accept-Ranges", "Content-Range", "Preference-Applied"}) {
        EXPECT_NE(get.header("access-control-expose-headers").find(name), std::string::npos)
            << name;
    }
}

TEST_F(RouterTest, EncodedSlashesAreNoSlashes) {
    start();
    EXPECT_TRUE(is_problem(ask("GET", "/v1%u002fjobs"), 400, "malformed-request"));
    for (const char* target :
         {"/v1%2fjobs", "/v1%2Fjobs", "/v1%5cjobs", "/v1%252fjobs", "/v1/x/../jobs", "/v1/%2e/jobs",
          "//v1/jobs", "/v1/jobs%3flimit=1", "/v1/library/spectra/.."}) {
        EXPECT_TRUE(is_problem(ask("GET", target), 404, "not-found")) << target;
    }
    EXPECT_EQ(ask("GET", "/v1/%6a%6Fbs").status, 200) << "an encoded letter is the letter";
}

TEST_F(RouterTest, ValidationNeedsNoJob) {
    start();
    EXPECT_EQ(ask("POST", "/v1/scenes/validate", {}, "{}").status, 200);
    EXPECT_TRUE(is_problem(ask("POST", "/v1/scenes/validate"), 400, "malformed-document"));
}

}  // namespace
}  // namespace bouguer::server::testing
