// SPDX-License-Identifier: Apache-2.0
// The table of malformed documents once more, against the whole service: sockets, routes, jobs.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "server/http/http_server.h"
#include "server/jobs/job_manager.h"
#include "server/log.h"
#include "server/storage/memory_asset_store.h"
#include "server/storage/memory_job_store.h"
#include "server/storage/memory_result_store.h"
#include "tests/api/fake_assets.h"
#include "tests/api/malformed_documents.h"
#include "tests/server/http/raw_client.h"

namespace bouguer::server {
namespace {

using Places = std::vector<std::pair<std::string, std::string>>;

Places places_of(const std::string& problem_document) {
    Places places;
    const auto json = nlohmann::json::parse(problem_document);
    for (const auto& problem : json.value("errors", nlohmann::json::array())) {
        places.emplace_back(problem.at("pointer"), problem.at("code"));
    }
    std::sort(places.begin(), places.end());
    return places;
}

TEST(MalformedDocumentsOverHttp, AreRefusedAndEndNothing) {
    set_log_level(LogLevel::Error);
    MemoryJobStore jobs;
    MemoryResultStore results;
    const tests::FakeAssets assets;
    JobManager manager(jobs, results, assets, {.threads = 1});
    ASSERT_TRUE(manager.start());
    MemoryAssetStore uploads;
    HttpOptions options;
    options.port = 0;
    options.allowed_hosts = {{"localhost", std::nullopt}};
    const auto server = HttpServer::start(manager, uploads, options, {});
    ASSERT_TRUE(server) << server.error().message;
    const auto ask = [&](const std::string& method, const std::string& path,
                         const std::string& body) {
        testing::RawClient client((*server)->port());
        client.send(testing::request_text(method, path, {}, body));
        return client.receive();
    };

    for (const tests::MalformedDocument& document : tests::malformed_documents()) {
        const auto answer = ask("POST", "/v1/jobs", document.body);
        EXPECT_EQ(answer.status, document.status) << document.name;
        EXPECT_EQ(answer.header("content-type"), "application/problem+json") << document.name;
        ASSERT_FALSE(answer.body.empty()) << document.name;
        EXPECT_EQ(places_of(answer.body), document.problems) << document.name;
    }
    EXPECT_EQ(ask("GET", "/livez", "").status, 200);
    EXPECT_TRUE(manager.list(100, "", std::nullopt)->jobs.empty()) << "nothing was accepted";
}

}  // namespace
}  // namespace bouguer::server
