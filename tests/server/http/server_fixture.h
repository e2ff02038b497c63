// SPDX-License-Identifier: Apache-2.0
// A server on a free loopback port over a fake service.
#pragma once

#include <gtest/gtest.h>

#include <mutex>
#include <vector>

#include "server/http/http_server.h"
#include "server/storage/memory_asset_store.h"
#include "tests/server/http/fake_job_service.h"
#include "tests/server/http/raw_client.h"

namespace bouguer::server::testing {

class ServerTest : public ::testing::Test {
  protected:
    /// Starts the server; once a test. It goes by "localhost" and "h" unless the test names hosts.
    void start(HttpOptions options = {}) {
        options.port = 0;
        if (options.allowed_hosts.empty()) {
            options.allowed_hosts = {{"localhost", std::nullopt}, {"h", std::nullopt}};
        }
        auto server = HttpServer::start(jobs, assets, options, [this](const AccessRecord& record) {
            const std::lock_guard lock(log_mutex_);
            log_.push_back(record);
        });
        ASSERT_TRUE(server) << server.error().message;
        server_ = std::move(*server);
    }
    HttpServer& server() { return *server_; }
    [[nodiscard]] const HttpServer& server() const { return *server_; }
    void destroy_server() { server_.reset(); }
    /// `source`: as of RawClient.
    [[nodiscard]] RawClient connect(const char* source = "127.0.0.1") const {
        return RawClient(server_->port(), source);
    }
    /// One request on a connection of its own.
    [[nodiscard]] RawResponse ask(std::string_view method, std::string_view target,
                                  const std::vector<std::string>& fields = {},
                                  std::string_view body = {}) const {
        return ask_raw(request_text(method, target, fields, body), method == "HEAD");
    }
    [[nodiscard]] RawResponse ask_raw(std::string_view bytes, bool head_only = false) const {
        RawClient client = connect();
        client.send(bytes);
        return client.receive(head_only);
    }
    /// What was logged so far.
    [[nodiscard]] std::vector<AccessRecord> log() {
        const std::lock_guard lock(log_mutex_);
        return log_;
    }

    FakeJobService jobs;
    MemoryAssetStore assets;

  private:
    std::mutex log_mutex_;
    std::vector<AccessRecord> log_;
    std::unique_ptr<HttpServer> server_;  // last: it ends before what it uses
};

/// The path of a job, or of something below it.
inline std::string path_of(const JobId& id, const std::string& below = {}) {
    return "/v1/jobs/" + id + below;
}

/// Whether a response is a problem document with this status and code.
inline bool is_problem(const RawResponse& response, int status, const std::string& code) {
    return response.status == status &&
           response.header("content-type") == "application/problem+json" &&
           response.body.find("/docs/problems#" + code + "\"") != std::string::npos;
}

}  // namespace bouguer::server::testing
