// SPDX-License-Identifier: Apache-2.0
#include "server/http/routes/job_routes.h"

#include <algorithm>
#include <charconv>

#include "server/http/conditions.h"
#include "server/http/problems.h"
#include "server/http/query.h"
#include "server/http/representation.h"
#include "server/http/routes/job_id_pattern.h"

namespace bouguer::server {
namespace {

using httplib::Request;
using httplib::Response;

constexpr std::size_t kDefaultLimit = 20, kLargestLimit = 100;
constexpr std::size_t kLongestKey = 200;

void set_json(Response& response, int status, std::string json) {
    response.status = status;
    response.body = std::move(json);
    response.set_header("Content-Type", "application/json");
}

/// Digits only, at most nine of them.
std::optional<std::size_t> small_number(const std::string& text) {
    std::size_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    const bool good = !text.empty() && text.size() <= 9 && stop == end && error == std::errc{};
    return good ? std::optional(value) : std::nullopt;
}

/// POST /v1/jobs -> 202 + Location.
void submit(JobService& jobs, const Request& request, Response& response, Exchange& exchange) {
    const std::string key = request.get_header_value("Idempotency-Key");
    if (key.size() > kLongestKey) {
        return send_problem(
            response,
            Refusal{400, "malformed-request", "The Idempotency-Key is longer than 200 bytes."},
            exchange.request_id);
    }
    const auto result = jobs.submit(request.body, key);
    if (!result) {
        const bool is_full = result.error().code == "queue-full";
        return send_problem(response, result.error(), exchange.request_id,
                            is_full ? jobs.retry_after_s() : kShortRetry_s);
    }
    response.set_header("Location", "/v1/jobs/" + result->view.job.id);
    response.set_header("Retry-After", std::to_string(jobs.retry_after_s()));
    if (result->replayed) response.set_header("Idempotent-Replayed", "true");
    set_json(response, 202, submitted_job_json(*result));
}

/// What GET /v1/jobs?limit=&cursor=&state= asks for.
struct ListQuery {
    std::size_t limit = kDefaultLimit;
    std::string cursor;  ///< empty: the first page
    std::optional<JobState> state;
};

std::string next_link(const std::string& cursor, const ListQuery& query) {
    std::string link = "</v1/jobs?limit=" + std::to_string(query.limit);
    if (query.state) link += "&state=" + std::string(to_string(*query.state));
    return link + "&cursor=" + cursor + ">; rel=\"next\"";
}

Result<ListQuery> read_list_query(const Request& request) {
    auto texts = query_of(request);
    if (!texts) return tl::unexpected(texts.error());
    const auto limit = take_optional(*texts, "limit");
    const auto state = take_optional(*texts, "state");
    ListQuery query;
    query.cursor = take_optional(*texts, "cursor").value_or("");
    if (auto all_taken = expect_empty(*texts); !all_taken) return tl::unexpected(all_taken.error());
    if (limit) query.limit = small_number(*limit).value_or(0);
    if (query.limit == 0 || query.limit > kLargestLimit) {
        return tl::unexpected(
            bad_parameter("limit", "out-of-range", *limit, "a number in [1, 100]"));
    }
    if (state) query.state = job_state_from(*state);
    if (state && !query.state) {
        return tl::unexpected(bad_parameter("state", "unknown-name", *state,
                                            "queued, running, done, failed or cancelled"));
    }
    return query;
}

/// GET /v1/jobs
void list(const JobService& jobs, const Request& request, Response& response, Exchange& exchange) {
    const auto query = read_list_query(request);
    if (!query) return send_problem(response, query.error(), exchange.request_id);
    const auto page = jobs.list(query->limit, query->cursor, query->state);
    if (!page) return send_problem(response, page.error(), exchange.request_id);
    if (!page->next_cursor.empty()) {
        response.set_header("Link", next_link(page->next_cursor, *query));
    }
    set_json(response, 200, job_page_json(*page));
}

/// Seconds of `Prefer: wait=N` [RFC 7240 §4.3]; 0: none.
std::chrono::seconds wished_wait(const Request& request, std::chrono::seconds longest) {
    const std::string prefer = request.get_header_value("Prefer");
    const auto at = prefer.find("wait=");
    if (at == std::string::npos || (at > 0 && prefer[at - 1] != ' ' && prefer[at - 1] != ',')) {
        return std::chrono::seconds(0);
    }
    const auto end = std::min(prefer.find_first_not_of("0123456789", at + 5), prefer.size());
    const auto seconds = small_number(prefer.substr(at + 5, end - at - 5)).value_or(0);
    return std::min(std::chrono::seconds(seconds), longest);
}

/// Leaves the connection waiting for the job's end. The event may come from any thread, even before
/// this returns.
bool begin_wait(JobService& jobs, const JobId& id, std::chrono::seconds at_most,
                Exchange& exchange) {
    auto ended = std::make_shared<std::atomic<bool>>(false);
    auto subscription = jobs.subscribe(id, [ended, wake = exchange.wake](const JobEvent& event) {
        if (event.type != "done") return;
        *ended = true;
        wake();
    });
    if (!subscription) return false;
    exchange.waiting =
        std::make_unique<Waiting>(Waiting{std::move(ended), std::move(*subscription), at_most});
    return true;
}

/// GET /v1/jobs/{id}, at once or, with Prefer: wait=N, when the job has ended.
void read(JobService& jobs, const HttpDeadlines& deadlines, const Request& request,
          Response& response, Exchange& exchange) {
    const JobId id = request.matches[1];
    const auto view = jobs.find(id);
    if (!view) return send_problem(response, view.error(), exchange.request_id);
    const auto wait = wished_wait(request, deadlines.longest_wait);
    const bool may_wait = wait.count() > 0 && exchange.wake && !exchange.waited;
    if (may_wait && !is_final(view->job.state) && begin_wait(jobs, id, wait, exchange)) return;
    if (wait.count() > 0) {
        response.set_header("Preference-Applied", "wait=" + std::to_string(wait.count()));
    }
    send_representation(request, response, json_representation(job_json(*view)), exchange);
}

/// Whether the job is as If-Match and If-None-Match say. False: the refusal has been sent. A job
/// that changes between this look and what follows it is changed all the same.
bool is_as_expected(const JobService& jobs, const JobId& id, const Request& request,
                    Response& response, const Exchange& exchange) {
    if (!has_conditions(request)) return true;
    const auto view = jobs.find(id);
    if (!view) {
        send_problem(response, view.error(), exchange.request_id);
        return false;
    }
    const auto refused =
        refused_by_condition(request, quoted_tag(json_representation(job_json(*view))));
    if (refused) send_problem(response, *refused, exchange.request_id);
    return !refused;
}

/// POST /v1/jobs/{id}/cancel
void cancel(JobService& jobs, const Request& request, Response& response, Exchange& exchange) {
    const JobId id = request.matches[1];
    if (!is_as_expected(jobs, id, request, response, exchange)) return;
    const auto view = jobs.cancel(id);
    if (!view) return send_problem(response, view.error(), exchange.request_id);
    set_json(response, 200, job_json(*view));
}

/// DELETE /v1/jobs/{id}
void remove(JobService& jobs, const Request& request, Response& response, Exchange& exchange) {
    const JobId id = request.matches[1];
    if (!is_as_expected(jobs, id, request, response, exchange)) return;
    const auto done = jobs.remove(id);
    if (!done) return send_problem(response, done.error(), exchange.request_id);
    response.status = 204;
}

}  // namespace

void add_job_routes(Router& router, JobService& jobs, const HttpDeadlines& deadlines) {
    router.post("/v1/jobs",
                [&jobs](const Request& request, Response& response, Exchange& exchange) {
                    submit(jobs, request, response, exchange);
                });
    router.get(
        "/v1/jobs",
        [&jobs](const Request& request, Response& response, Exchange& exchange) {
            list(jobs, request, response, exchange);
        },
        Query::Read);
    router.get(job_path(),
               [&jobs, deadlines](const Request& request, Response& response, Exchange& exchange) {
                   read(jobs, deadlines, request, response, exchange);
               });
    router.post(job_path("/cancel"),
                [&jobs](const Request& request, Response& response, Exchange& exchange) {
                    cancel(jobs, request, response, exchange);
                });
    router.del(job_path(), [&jobs](const Request& request, Response& response, Exchange& exchange) {
        remove(jobs, request, response, exchange);
    });
}

}  // namespace bouguer::server
