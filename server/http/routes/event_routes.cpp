// SPDX-License-Identifier: Apache-2.0
#include "server/http/routes/event_routes.h"

#include "server/http/problems.h"
#include "server/http/routes/job_id_pattern.h"

namespace bouguer::server {
namespace {

/// Whether the client has been told the end of this job, which is the end still.
Result<bool> has_seen_the_end(const JobService& jobs, const JobId& id,
                              const httplib::Request& request) {
    if (request.get_header_value("Last-Event-ID") != kDoneEventId) return false;
    return jobs.find(id).map([](const JobView& view) { return is_final(view.job.state); });
}

}  // namespace

void add_event_routes(Router& router, JobService& jobs, const HttpOptions& options) {
    router.get(job_path("/events"), [&jobs, limits = options.limits, deadlines = options.deadlines](
                                        const httplib::Request& request,
                                        httplib::Response& response, Exchange& exchange) {
        const JobId id = request.matches[1];
        const auto is_over = has_seen_the_end(jobs, id, request);
        if (!is_over) return send_problem(response, is_over.error(), exchange.request_id);
        if (*is_over) {
            response.status = 204;
            return;
        }
        auto inbox =
            std::make_shared<EventInbox>(deadlines.progress_interval, limits.event_buffer_bytes);
        auto subscription =
            jobs.subscribe(id, [inbox](const JobEvent& event) { inbox->push(event); });
        if (!subscription) {
            return send_problem(response, subscription.error(), exchange.request_id);
        }
        response.status = 200;
        response.set_header("Content-Type", "text/event-stream");
        response.set_header("X-Accel-Buffering", "no");
        if (request.method == "HEAD") return;
        exchange.stream =
            std::make_unique<EventStream>(EventStream{std::move(inbox), std::move(*subscription)});
    });
}

}  // namespace bouguer::server
