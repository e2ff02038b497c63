// SPDX-License-Identifier: Apache-2.0
#include "tests/server/http/server_fixture.h"

namespace bouguer::server::testing {
namespace {

using JobRoutesTest = ServerTest;

TEST_F(JobRoutesTest, SubmitAnswers202WithTheJobsAddress) {
    start();
    const auto response = ask("POST", "/v1/jobs", {"Idempotency-Key: a%0D%0Ab"}, R"({"a":1})");
    EXPECT_EQ(response.status, 202);
    EXPECT_EQ(response.header("location").rfind("/v1/jobs/01890000-", 0), 0U);
    EXPECT_EQ(response.header("retry-after"), "37") << "as the jobs measure it";
    EXPECT_EQ(jobs.last_body, R"({"a":1})");
    EXPECT_EQ(jobs.last_key, "a%0D%0Ab") << "header values are not percent-decoded";
    EXPECT_EQ(response.header("idempotent-replayed"), "");
    EXPECT_EQ(ask("GET", response.header("location")).status, 200);
}

TEST_F(JobRoutesTest, SubmitSaysWhenItReplays) {
    start();
    const auto first = ask("POST", "/v1/jobs", {"Idempotency-Key: k"}, "{}");
    const auto second = ask("POST", "/v1/jobs", {"Idempotency-Key: k"}, "{}");
    EXPECT_EQ(second.status, 202);
    EXPECT_EQ(second.header("idempotent-replayed"), "true");
    EXPECT_EQ(second.header("location"), first.header("location"));
}

TEST_F(JobRoutesTest, RefusalsOfTheServiceBecomeProblems) {
    start();
    const auto invalid = ask("POST", "/v1/jobs", {}, "[]");
    EXPECT_TRUE(is_problem(invalid, 422, "invalid-document")) << invalid.body;
    EXPECT_NE(invalid.body.find(R"("pointer":"/scene")"), std::string::npos);
    jobs.is_full = true;
    const auto busy = ask("POST", "/v1/jobs", {}, "{}");
    EXPECT_TRUE(is_problem(busy, 503, "queue-full")) << busy.body;
    EXPECT_EQ(busy.header("retry-after"), "37") << "as the jobs measure it";
}

TEST_F(JobRoutesTest, OnlyJsonIsSubmitted) {
    start();
    const auto response = ask_raw(
        "POST /v1/jobs HTTP/1.1\r\nHost: h\r\nContent-Type: text/plain\r\nContent-Length: "
        "2\r\n\r\n{}");
    EXPECT_TRUE(is_problem(response, 415, "media-type-not-supported")) << response.body;
}

TEST_F(JobRoutesTest, ListGoesFromPageToPage) {
    start();
    for (int i = 0; i < 5; ++i) jobs.add();
    std::size_t pages = 0;
    std::string target = "/v1/jobs?limit=2";
    while (!target.empty()) {
        const auto response = ask("GET", target);
        ASSERT_EQ(response.status, 200);
        ++pages;
        const std::string link = response.header("link");
        ASSERT_TRUE(link.empty() || link.find("rel=\"next\"") != std::string::npos);
        target = link.empty() ? "" : link.substr(1, link.find('>') - 1);
    }
    EXPECT_EQ(pages, 3U);
}

TEST_F(JobRoutesTest, ListRefusesWhatItDoesNotKnow) {
    start();
    for (const char* query :
         {"limit=0", "limit=101", "limit=-1", "limit=1e1", "limit=99999999999", "limit=", "limit",
          "state=asleep", "state=", "limit=2&limit=2", "State=done", "=1"}) {
        EXPECT_TRUE(is_problem(ask("GET", std::string("/v1/jobs?") + query), 422, "invalid-query"))
            << query;
    }
    EXPECT_EQ(ask("GET", "/v1/jobs?state=running&limit=100").status, 200);
}

TEST_F(JobRoutesTest, ParametersThatMeanNothingAreRefusedByName) {
    start();
    const auto twice = ask("GET", "/v1/jobs?limit=1&limit=2");
    EXPECT_TRUE(is_problem(twice, 422, "invalid-query"));
    EXPECT_NE(twice.body.find("query parameter limit"), std::string::npos);
    const auto unknown = ask("GET", "/v1/jobs?limt=1&status=done&limit=5");
    EXPECT_TRUE(is_problem(unknown, 422, "invalid-query"));
    EXPECT_NE(unknown.body.find("query parameter limt"), std::string::npos);
    EXPECT_NE(unknown.body.find("query parameter status"), std::string::npos);
    const JobId id = jobs.add();
    for (const char* target : {"/v1/library?a=1", "/v1/library/spectra/D65?a=1", "/docs?a=1"}) {
        EXPECT_TRUE(is_problem(ask("GET", target), 422, "invalid-query")) << target;
    }
    EXPECT_TRUE(is_problem(ask("GET", path_of(id, "?a=1")), 422, "invalid-query"));
    EXPECT_TRUE(is_problem(ask("GET", path_of(id, "/events?a=1")), 422, "invalid-query"));
    EXPECT_TRUE(is_problem(ask("POST", path_of(id, "/cancel?a=1")), 422, "invalid-query"));
    EXPECT_EQ(ask("GET", "/?v=7").status, 200);
}

TEST_F(JobRoutesTest, ChangesNothingThatIsNotAsExpected) {
    start();
    const JobId id = jobs.add();
    const std::string tag = ask("GET", path_of(id)).header("etag");
    const std::string good = "If-Match: " + tag;
    const std::string bad = "If-Match: \"0123\"";
    EXPECT_TRUE(is_problem(ask("DELETE", path_of(id), {bad}), 412, "precondition-failed"));
    EXPECT_TRUE(is_problem(ask("POST", path_of(id, "/cancel"), {bad}), 412, "precondition-failed"));
    EXPECT_EQ(ask("GET", path_of(id), {good}).header("etag"), tag) << "nothing has changed";
    EXPECT_EQ(ask("POST", path_of(id, "/cancel"), {good}).status, 200);
    EXPECT_TRUE(
        is_problem(ask("DELETE", path_of(id), {"If-None-Match: *"}), 412, "precondition-failed"));
    EXPECT_EQ(ask("DELETE", path_of(id), {"If-Match: *"}).status, 204);
    EXPECT_EQ(ask("DELETE", path_of(id), {"If-Match: *"}).status, 404);
}

TEST_F(JobRoutesTest, WhatIsNoUuidIsNotFound) {
    start();
    const JobId id = jobs.add();
    for (const std::string& bad :
         {std::string("x"), id + "0", id.substr(1), std::string("../jobs"), std::string("%00"),
          std::string("01890000-0000-7000-8000-ZZZZZZZZZZZZ")}) {
        EXPECT_TRUE(is_problem(ask("GET", path_of(bad)), 404, "not-found")) << bad;
    }
    const JobId unknown = "01890000-0000-7000-8000-ffffffffffff";
    EXPECT_TRUE(is_problem(ask("GET", path_of(unknown)), 404, "not-found"));
    EXPECT_TRUE(is_problem(ask("POST", path_of(unknown, "/cancel")), 404, "not-found"));
    EXPECT_TRUE(is_problem(ask("DELETE", path_of(unknown)), 404, "not-found"));
    EXPECT_TRUE(is_problem(ask("GET", path_of(unknown, "/events")), 404, "not-found"));
}

TEST_F(JobRoutesTest, TheTagChangesWithTheJob) {
    start();
    const JobId id = jobs.add();
    const auto first = ask("GET", path_of(id));
    ASSERT_FALSE(first.header("etag").empty());
    const std::vector<std::string> condition{"If-None-Match: " + first.header("etag")};
    const auto same = ask("GET", path_of(id), condition);
    EXPECT_EQ(same.status, 304);
    EXPECT_TRUE(same.body.empty());
    jobs.finish(id);
    EXPECT_EQ(ask("GET", path_of(id), condition).status, 200);
}

TEST_F(JobRoutesTest, CancelIsIdempotentAndDeleteLeavesNothing) {
    start();
    const JobId id = jobs.add();
    EXPECT_EQ(ask("POST", path_of(id, "/cancel")).status, 200);
    const auto again = ask("POST", path_of(id, "/cancel"));
    EXPECT_EQ(again.status, 200);
    EXPECT_NE(again.body.find("cancelled"), std::string::npos);
    EXPECT_EQ(ask("DELETE", path_of(id)).status, 204);
    EXPECT_EQ(ask("GET", path_of(id)).status, 404);
}

TEST_F(JobRoutesTest, WrongMethodsAreToldTheRightOnes) {
    start();
    const JobId id = jobs.add();
    const auto put = ask("PUT", path_of(id), {}, "{}");
    EXPECT_TRUE(is_problem(put, 405, "method-not-allowed")) << put.body;
    EXPECT_EQ(put.header("allow"), "GET, HEAD, DELETE, OPTIONS");
    EXPECT_EQ(ask("GET", path_of(id, "/cancel")).header("allow"), "POST, OPTIONS");
    EXPECT_EQ(ask("POST", "/livez").status, 405);
    const auto options = ask("OPTIONS", "/v1/jobs");
    EXPECT_EQ(options.status, 204);
    EXPECT_EQ(options.header("allow"), "POST, GET, HEAD, OPTIONS");
    EXPECT_TRUE(is_problem(ask("GET", "/nowhere"), 404, "not-found"));
}

TEST_F(JobRoutesTest, HeadIsGetWithoutTheBody) {
    start();
    const JobId id = jobs.add();
    const auto get = ask("GET", path_of(id));
    const auto head = ask("HEAD", path_of(id));
    EXPECT_EQ(head.status, 200);
    EXPECT_EQ(head.header("content-length"), get.header("content-length"));
    EXPECT_EQ(head.header("etag"), get.header("etag"));
}

TEST_F(JobRoutesTest, PreferWaitAnswersWhenTheJobEnds) {
    HttpOptions options;
    options.handler_threads = 1;
    start(options);
    const JobId id = jobs.add();
    std::vector<RawClient> waiting;
    for (int i = 0; i < 20; ++i) {
        waiting.push_back(connect());
        waiting.back().send(request_text("GET", path_of(id), {"Prefer: wait=20"}));
    }
    // they wait without a thread: the only one is free for others
    while (jobs.listeners() < waiting.size()) EXPECT_EQ(ask("GET", "/v1/jobs").status, 200);
    jobs.finish(id);
    for (RawClient& client : waiting) {
        const auto response = client.receive();
        EXPECT_EQ(response.status, 200);
        EXPECT_EQ(response.header("preference-applied"), "wait=20");
        EXPECT_NE(response.body.find("\"done\""), std::string::npos);
    }
    EXPECT_EQ(jobs.listeners(), 0U);
}

TEST_F(JobRoutesTest, PreferWaitGivesUpInTime) {
    HttpOptions options;
    options.deadlines.longest_wait = std::chrono::seconds(1);
    start(options);
    const JobId id = jobs.add();
    const auto response = ask("GET", path_of(id), {"Prefer: wait=9999"});
    EXPECT_EQ(response.status, 200);
    EXPECT_NE(response.body.find("\"running\""), std::string::npos);
}

TEST_F(JobRoutesTest, MemoryThatRunsOutIsA503ToTryAgain) {
    start();
    const JobId id = jobs.add();
    jobs.on_find([] { throw std::bad_alloc(); });
    const auto response = ask("GET", path_of(id));
    EXPECT_TRUE(is_problem(response, 503, "out-of-memory")) << response.body;
    EXPECT_NE(response.header("retry-after"), "");
    jobs.on_find([] {});
    EXPECT_EQ(ask("GET", path_of(id)).status, 200);
}

TEST_F(JobRoutesTest, AnExceptionIsA500WithoutItsText) {
    start();
    const JobId id = jobs.add();
    jobs.on_find([] { throw std::runtime_error("secret"); });
    const auto response = ask("GET", path_of(id), {"X-Request-Id: my-id.1"});
    EXPECT_TRUE(is_problem(response, 500, "internal-error")) << response.body;
    EXPECT_EQ(response.body.find("secret"), std::string::npos);
    EXPECT_EQ(response.header("x-request-id"), "my-id.1");
    ASSERT_EQ(log().size(), 1U);
    EXPECT_EQ(log()[0].error, "secret");
    EXPECT_EQ(log()[0].status, 500);
    jobs.on_find([] { throw 7; });
    EXPECT_EQ(ask("GET", path_of(id)).status, 500);
    jobs.on_find(nullptr);
    EXPECT_EQ(ask("GET", path_of(id)).status, 200);
}

}  // namespace
}  // namespace bouguer::server::testing
