// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/job_film.h"

#include "api/digest.h"
#include "renderer/film/picture_file.h"

namespace bouguer::server {
namespace {

Result<renderer::OutputSettings> output_of(const JobService& jobs, const JobId& id) {
    const auto report = jobs.file(id, "report.json");
    if (!report) return tl::unexpected(report.error());
    const auto text = report->content.all();
    if (!text) return tl::unexpected(text.error());
    return api::read_report_output(*text);
}

/// The film with `output` in place of the job's own settings.
Result<JobFilm> film_with(const JobService& jobs, const JobId& id,
                          renderer::OutputSettings output) {
    const auto exr = jobs.file(id, "image.exr");
    if (!exr) return tl::unexpected(exr.error());
    const auto bytes = exr->content.all();
    if (!bytes) return tl::unexpected(bytes.error());
    auto loaded = renderer::load_picture(*bytes);
    if (!loaded) return fail(ErrorKind::Internal, loaded.error().message, "result-damaged");
    return JobFilm{std::move(loaded->picture), std::move(output), exr->final};
}

}  // namespace

Result<JobFilm> film_of(const JobService& jobs, const JobId& id) {
    auto output = output_of(jobs, id);
    if (!output) return tl::unexpected(output.error());
    return film_with(jobs, id, std::move(*output));
}

Result<ResultFile> image_anew(const JobService& jobs, const JobId& id, const std::string& name,
                              const api::OutputTexts& texts) {
    const bool is_png = name == "image.png";
    const auto own = output_of(jobs, id);
    if (!own) return tl::unexpected(own.error());
    auto asked =
        api::read_output_texts(texts, is_png ? api::OutputScope::Png : api::OutputScope::Exr, *own);
    if (!asked) return tl::unexpected(asked.error());
    const auto film = film_with(jobs, id, std::move(*asked));
    if (!film) return tl::unexpected(film.error());
    auto bytes = is_png ? renderer::encode_png(film->picture, film->output)
                        : renderer::encode_exr(film->picture, film->output);
    if (!bytes) return tl::unexpected(bytes.error());
    std::string digest = api::sha256_hex(*bytes);
    return ResultFile{std::move(*bytes), is_png ? "image/png" : "image/x-exr", std::move(digest),
                      film->final};
}

}  // namespace bouguer::server
