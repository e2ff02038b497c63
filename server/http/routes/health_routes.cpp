// SPDX-License-Identifier: Apache-2.0
#include "server/http/routes/health_routes.h"

#include "api/json_builder.h"
#include "server/http/plain_answer.h"

namespace bouguer::server {
namespace {

constexpr int kRetry_s = 1;

struct Health {
    int status;
    std::string json;
};

Health livez() { return {200, "{\"status\":\"alive\"}\n"}; }

Health readyz(const JobService& jobs) {
    const Readiness readiness = jobs.readiness();
    api::JsonObject json;
    json.set("status", readiness.ready ? "ready" : "not ready");
    if (!readiness.ready) json.set("reason", readiness.reason);
    json.set("queued", static_cast<std::uint64_t>(jobs.queue_length()));
    return {readiness.ready ? 200 : 503, json.text() + "\n"};
}

void send(httplib::Response& response, Health health) {
    response.status = health.status;
    response.body = std::move(health.json);
    response.set_header("Content-Type", "application/json");
    if (health.status == 503) response.set_header("Retry-After", std::to_string(kRetry_s));
}

}  // namespace

bool answer_health(const JobService& jobs, Exchange& exchange) {
    const std::string_view path = exchange.head.path();
    const std::string& method = exchange.head.method;
    if ((path != "/livez" && path != "/readyz") || (method != "GET" && method != "HEAD")) {
        return false;
    }
    Health health = path == "/livez" ? livez() : readyz(jobs);
    exchange.status = health.status;
    exchange.answer = to_bytes({.status = health.status,
                                .body = std::move(health.json),
                                .request_id = exchange.request_id,
                                .retry_after_s = health.status == 503 ? kRetry_s : 0,
                                .close = exchange.close,
                                .head_only = method == "HEAD"});
    return true;
}

void add_health_routes(Router& router, const JobService& jobs) {
    router.get("/livez", [](const httplib::Request&, httplib::Response& response, Exchange&) {
        send(response, livez());
    });
    router.get("/readyz", [&jobs](const httplib::Request&, httplib::Response& response, Exchange&) {
        send(response, readyz(jobs));
    });
}

}  // namespace bouguer::server
