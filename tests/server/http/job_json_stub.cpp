// SPDX-License-Identifier: Apache-2.0
#include "api/json_builder.h"
#include "server/jobs/job_service.h"
namespace bouguer::server {
__attribute__((weak)) std::string job_json(const JobView& view) {
    return api::JsonObject().set("id", view.job.id).set("state", to_string(view.job.state)).text();
}
__attribute__((weak)) std::string job_page_json(const JobPage& page) {
    api::JsonArray jobs;
    for (const JobView& view : page.jobs) jobs.add_json(job_json(view));
    return api::JsonObject().set_json("jobs", jobs.text()).text();
}
}  // namespace bouguer::server
