// SPDX-License-Identifier: Apache-2.0
#include "api/job_document.h"

#include <cstdint>
#include <new>
#include <utility>

#include "api/digest.h"
#include "api/document_assets.h"
#include "api/job_reader.h"
#include "api/json_builder.h"
#include "api/json_parser.h"
#include "api/json_reader.h"
#include "api/json_text.h"
#include "api/read_context.h"
#include "api/scene_reader.h"
#include "api/scene_warnings.h"
#include "renderer/core/out_of_memory.h"

namespace bouguer::api {
namespace {

/// Whether a document means to be a job: by its format, or by what it has when that is absent.
bool is_job(const Json& document) {
    if (!document.is_object()) return true;
    if (const auto format = document.find("format")) return !format->is_text(kSceneFormat);
    return document.contains("scene") || !document.contains("objects");
}

/// Names the job by its members, which come sorted: that is its canonical form.
class JobNames {
  public:
    void add(std::string_view key, const std::string& canonical) {
        whole_.set_json(key, canonical);
        if (key != "priority" && key != "labels") work_.set_json(key, canonical);
        if (key == "scene") scene_digest_ = digest_of(canonical);
    }
    void give_to(JobRequest& job) const {
        job.canonical = whole_.text();
        job.scene_digest = scene_digest_;
        job.digest = digest_of(work_.text());
    }

  private:
    JsonObject whole_, work_;
    std::string scene_digest_;
};

void name_job(const Json& document, JobRequest& job) {
    JobNames names;
    for (const auto& [key, value] : document.members()) names.add(key, canonical_text(value));
    names.give_to(job);
}

/// Names a scene alone as the job with every default.
void name_job_around(const Json& scene, JobRequest& job) {
    JobNames names;
    names.add("format", json_string(kJobFormat));
    names.add("scene", canonical_text(scene));
    names.give_to(job);
}

/// Reads a whole job into `job`.
void read_job(const JsonValue& document, const ReadContext& context, JobRequest& job) {
    JsonReader reader(document);
    if (!reader.is_object() || !read_format(reader, kJobFormat)) return;
    if (const auto scene = reader.require("scene"))
        job.scene = read_scene(*scene, context, job.notes);
    read_job_settings(reader, context.limits, job);
    reader.reject_unknown_keys();
    if (document.problems().empty())
        warn_of_job(job.scene, job.settings, job.output, document.pointer() + "/scene",
                    document.problems());
}

/// Reads a scene alone as a job with every default into `job`.
void read_job_around(const JsonValue& scene, const ReadContext& context, JobRequest& job) {
    job.scene = read_scene(scene, context, job.notes);
    // The defaults cannot be at fault: what is reported here belongs to the scene's camera.
    const JsonStore nothing;
    JsonReader settings(JsonValue(Json(nothing, {JsonNode::Kind::Object}), "", scene.problems()));
    read_job_settings(settings, context.limits, job);
    if (scene.problems().empty())
        warn_of_job(job.scene, job.settings, job.output, scene.pointer(), scene.problems());
}

enum class Wanted : std::uint8_t { JobOrScene, Scene };

Result<JobRequest> read_request(std::string_view text, const Limits& limits,
                                const AssetSource& assets, Wanted wanted) {
    const auto tree = read_json_tree(text, limits);
    if (!tree) return tl::unexpected(tree.error());
    const Json document = tree->root();
    const bool is_scene = wanted == Wanted::Scene || !is_job(document);
    Problems problems(limits.problems);
    DocumentAssets document_assets(assets, limits);
    const ReadContext context{limits, document_assets};
    const auto read = is_scene ? &read_job_around : &read_job;
    JobRequest job;
    read(JsonValue(document, "", problems), context, job);
    if (problems.empty() && document_assets.is_over_limit()) {  // in a place that nothing reads
        problems.add({"", "over-limit", "the files of this document are too large", {}, {}});
    }
    if (!problems.empty()) {
        return tl::unexpected(std::move(problems).to_error(ErrorKind::InvalidInput));
    }
    const auto name = is_scene ? &name_job_around : &name_job;
    name(document, job);
    job.files_digest = document_assets.digest();
    job.warnings = problems.warnings();
    return job;
}

Result<JobRequest> parse(std::string_view text, const Limits& limits, const AssetSource& assets,
                         Wanted wanted) {
    try {
        return read_request(text, limits, assets, wanted);
    } catch (const std::bad_alloc&) {
        return out_of_memory();
    }
}

}  // namespace

Result<std::string> AssetSource::read(std::string_view name) const {
    const auto file = open(name);
    if (!file) return tl::unexpected(file.error());
    return (*file)->read(0, (*file)->size());
}

Result<JobRequest> parse_job(std::string_view text, const Limits& limits,
                             const AssetSource& assets) {
    return parse(text, limits, assets, Wanted::JobOrScene);
}

Result<JobRequest> parse_scene(std::string_view text, const Limits& limits,
                               const AssetSource& assets) {
    return parse(text, limits, assets, Wanted::Scene);
}

}  // namespace bouguer::api
