// SPDX-License-Identifier: Apache-2.0
#include "server/http/routes/event_routes.h"

#include "server/http/problems.h"
#include "server/http/routes/job_id_pattern.h"

namespace bouguer::server {

void add_event_routes(Router& router, JobService& jobs, const HttpOptions& options) {
    router.get(job_path("/events"), [&jobs, limits = options.limits, deadlines = options.deadlines](
                                        const httplib::Request& request,
                                        httplib::Response& response, Exchange& exchange) {
        auto inbox =
            std::make_shared<EventInbox>(deadlines.progress_interval, limits.event_buffer_bytes);
        auto subscription = jobs.subscribe(request.matches[1],
                                           [inbox](const JobEvent& event) { inbox->push(event); });
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
