// SPDX-License-Identifier: Apache-2.0
// The JSON of jobs, as GET /v1/jobs and the events give it.
#include "server/jobs/job_json.h"

#include "api/json_builder.h"
#include "api/writers.h"
#include "server/jobs/job_service.h"
#include "server/utc_time.h"

namespace bouguer::server {
namespace {

std::optional<std::string> time_text(std::int64_t ms) {
    if (ms == 0) return std::nullopt;
    return utc_text(ms);
}

std::string labels_json(const std::map<std::string, std::string>& labels) {
    api::JsonObject json;
    for (const auto& [name, value] : labels) json.set(name, value);
    return json.text();
}

std::string names_json(const std::vector<std::string>& names) {
    api::JsonArray json;
    for (const std::string& name : names) json.add(name);
    return json.text();
}

std::string estimate_json(const std::optional<renderer::Estimate>& estimate) {
    if (!estimate) return "null";
    return api::JsonObject()
        .set("value", estimate->value)
        .set("low", estimate->low)
        .set("high", estimate->high)
        .text();
}

}  // namespace

std::string progress_json(const JobProgress& progress) {
    return api::JsonObject()
        .set("fraction", progress.fraction)
        .set("samples", progress.samples)
        .set("pass", progress.pass)
        .set("rays", progress.rays)
        .set("seconds", progress.seconds)
        .set("seconds_left", progress.seconds_left)
        .set_json("rmse", estimate_json(progress.rmse))
        .set_json("relative_rmse", estimate_json(progress.relative_rmse))
        .text();
}

std::string progress_event_json(const JobId& id, const JobProgress& progress) {
    return api::JsonObject().set("id", id).set_json("progress", progress_json(progress)).text();
}

namespace {

api::JsonObject job_object(const JobView& view) {
    const Job& job = view.job;
    api::JsonObject json;
    json.set("id", job.id)
        .set("state", to_string(job.state))
        .set("revision", job.revision)
        .set("attempts", job.attempts)
        .set("name", job.name)
        .set("priority", job.priority)
        .set_json("labels", labels_json(job.labels))
        .set("created", time_text(job.created_ms))
        .set("started", time_text(job.started_ms))
        .set("ended", time_text(job.ended_ms))
        .set("scene_digest", job.scene_digest)
        .set("digest", job.digest)
        .set_json("progress", progress_json(view.progress))
        .set_json("images", names_json(view.images));
    if (job.state == JobState::Failed) {
        json.set("failure", job.failure);
        json.set("failure_code", job.failure_code.empty() ? "render-failed" : job.failure_code);
    }
    return json;
}

}  // namespace

std::string job_json(const JobView& view) { return job_object(view).text(); }

std::string submitted_job_json(const SubmitResult& result) {
    return job_object(result.view).set_json("warnings", api::warnings_json(result.warnings)).text();
}

std::string job_page_json(const JobPage& page) {
    api::JsonArray jobs;
    for (const JobView& view : page.jobs) jobs.add_json(job_json(view));
    std::optional<std::string> cursor;
    if (!page.next_cursor.empty()) cursor = page.next_cursor;
    return api::JsonObject().set_json("jobs", jobs.text()).set("next_cursor", cursor).text();
}

}  // namespace bouguer::server
