// SPDX-License-Identifier: Apache-2.0
#include "server/http/problems.h"

#include "api/writers.h"
#include "server/http/plain_answer.h"

namespace bouguer::server {
namespace {

constexpr const char* kProblemType = "application/problem+json";

void send(httplib::Response& response, int status, std::string body) {
    response.status = status;
    response.body = std::move(body);
    response.headers.erase("Content-Type");
    response.set_header("Content-Type", kProblemType);
    response.headers.erase("Cache-Control");
    response.set_header("Cache-Control", "no-store");
}

}  // namespace

void send_problem(httplib::Response& response, const Error& error, std::string_view request_id,
                  int retry_after_s) {
    const int status = api::status_of(error);
    send(response, status, api::problem_json(error, request_id));
    if (status == 503 || status == 507) {
        response.set_header("Retry-After", std::to_string(retry_after_s));
    }
}

void send_problem(httplib::Response& response, const Refusal& refusal,
                  std::string_view request_id) {
    send(response, refusal.status, problem_text(refusal, request_id));
}

void send_not_found(httplib::Response& response, std::string_view request_id) {
    send_problem(response, Refusal{404, "not-found", "There is nothing at this address."},
                 request_id);
}

}  // namespace bouguer::server
