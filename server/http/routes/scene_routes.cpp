// SPDX-License-Identifier: Apache-2.0
#include "server/http/routes/scene_routes.h"

#include "server/http/problems.h"

namespace bouguer::server {

void add_scene_routes(Router& router, const JobService& jobs) {
    router.post("/v1/scenes/validate", [&jobs](const httplib::Request& request,
                                               httplib::Response& response, Exchange& exchange) {
        auto json = jobs.validate(request.body);
        if (!json) return send_problem(response, json.error(), exchange.request_id);
        response.status = 200;
        response.body = std::move(*json);
        response.set_header("Content-Type", "application/json");
    });
}

}  // namespace bouguer::server
