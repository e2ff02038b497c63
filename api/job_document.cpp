// SPDX-License-Identifier: Apache-2.0
#include "api/job_document.h"

#include <utility>

#include "api/digest.h"
#include "api/document_assets.h"
#include "api/job_reader.h"
#include "api/json_reader.h"
#include "api/json_tree.h"
#include "api/read_context.h"
#include "api/scene_reader.h"

namespace bouguer::api {
namespace {

std::string document_digest(const Json& document) { return digest_of(canonical_text(document)); }

/// Whether a document means to be a job: by its format, or by what it has when that is absent.
bool is_job(const Json& document) {
    if (!document.is_object()) return true;
    if (const auto format = document.find("format"); format != document.end()) {
        return *format != kSceneFormat;
    }
    return document.contains("scene") || !document.contains("objects");
}

/// Names the job; `document` is that of a job and is used up.
void add_digests(Json document, JobRequest& job) {
    job.canonical = canonical_text(document);
    job.scene_digest = document_digest(document["scene"]);
    document.erase("priority");
    document.erase("labels");
    job.digest = document_digest(document);
}

/// Reads a whole job into `job`.
void read_job(const JsonValue& document, const ReadContext& context, JobRequest& job) {
    JsonReader reader(document);
    if (!reader.is_object() || !read_format(reader, kJobFormat)) return;
    if (const auto scene = reader.require("scene"))
        job.scene = read_scene(*scene, context, job.notes);
    read_job_settings(reader, context.limits, job);
    reader.reject_unknown_keys();
}

/// A scene alone as a job with every default.
Json job_around(Json scene) {
    Json job = Json::object();
    job["format"] = kJobFormat;
    job["scene"] = std::move(scene);
    return job;
}

Result<JobRequest> parse(std::string_view text, const Limits& limits, const AssetSource& assets,
                         bool must_be_scene) {
    auto tree = read_json_tree(text, limits);
    if (!tree) return tl::unexpected(std::move(tree).error());
    Problems problems(limits.problems);
    DocumentAssets document_assets(assets, limits);
    const ReadContext context{limits, document_assets};
    JobRequest job;
    if (!must_be_scene && is_job(*tree)) {
        read_job(JsonValue(*tree, "", problems), context, job);
    } else {
        job.scene = read_scene(JsonValue(*tree, "", problems), context, job.notes);
        tree = job_around(*std::move(tree));
        // The defaults cannot be at fault: what is reported here belongs to the scene's camera.
        JsonReader settings(JsonValue(*tree, "", problems));
        read_job_settings(settings, limits, job);
    }
    if (!problems.empty()) {
        return tl::unexpected(std::move(problems).to_error(ErrorKind::InvalidInput));
    }
    add_digests(*std::move(tree), job);
    job.files_digest = document_assets.digest();
    return job;
}

}  // namespace

Result<JobRequest> parse_job(std::string_view text, const Limits& limits,
                             const AssetSource& assets) {
    return parse(text, limits, assets, false);
}

Result<JobRequest> parse_scene(std::string_view text, const Limits& limits,
                               const AssetSource& assets) {
    return parse(text, limits, assets, true);
}

}  // namespace bouguer::api
