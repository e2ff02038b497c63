// SPDX-License-Identifier: Apache-2.0
#include "server/http/routes/compare_routes.h"

#include <array>

#include "api/digest.h"
#include "api/writers.h"
#include "server/http/problems.h"
#include "server/http/query.h"
#include "server/http/representation.h"
#include "server/jobs/job_film.h"
#include "server/jobs/job_id.h"

namespace bouguer::server {
namespace {

using httplib::Request;
using httplib::Response;

constexpr std::array<std::string_view, 2> kTypes{"application/json", "image/png"};

struct Comparison {
    JobId a, b;
    renderer::OutputSettings output;
    renderer::PictureDifference difference;
};

/// `error` with the parameter that it is about.
tl::unexpected<Error> about(const std::string& name, const JobId& id, Error error) {
    error.message = "job " + name + " (" + id + "): " + error.message;
    return tl::unexpected(std::move(error));
}

/// A job of the query that has ended, so that the answer stays true.
Result<JobId> take_job(const JobService& jobs, std::map<std::string, std::string>& query,
                       const std::string& name) {
    auto id = take_required(query, name, "the id of a job");
    if (!id) return id;
    if (!is_job_id(*id))
        return about(name, *id, {ErrorKind::NotFound, "there is no such job", {}, {}});
    const auto view = jobs.find(*id);
    if (!view) return about(name, *id, view.error());
    if (!is_final(view->job.state))
        return about(name, *id, {ErrorKind::Conflict, "it has not ended", {}, "job-not-finished"});
    return id;
}

Result<Comparison> compare(const JobService& jobs, std::map<std::string, std::string> query) {
    auto id_a = take_job(jobs, query, "a");
    if (!id_a) return tl::unexpected(id_a.error());
    auto id_b = take_job(jobs, query, "b");
    if (!id_b) return tl::unexpected(id_b.error());
    auto a = film_of(jobs, *id_a);
    if (!a) return about("a", *id_a, a.error());
    auto output = api::read_output_texts(query, api::OutputScope::Comparison, a->output);
    if (!output) return tl::unexpected(bad_query(output.error()));
    auto b = film_of(jobs, *id_b);
    if (!b) return about("b", *id_b, b.error());
    auto difference =
        renderer::compare_pictures({std::move(a->picture)}, {std::move(b->picture)}, *output);
    if (!difference) return tl::unexpected(difference.error());
    return Comparison{*id_a, *id_b, *output, std::move(*difference)};
}

Result<ResultFile> file_of(const Comparison& comparison, std::string_view type) {
    std::string bytes;
    if (type == "image/png") {
        auto map = renderer::encode_difference_map(comparison.difference);
        if (!map) return tl::unexpected(map.error());
        bytes = std::move(*map);
    } else {
        bytes = api::comparison_json(comparison.difference, comparison.output, comparison.a,
                                     comparison.b);
    }
    std::string digest = api::sha256_hex(bytes);
    return ResultFile{std::move(bytes), std::string(type), std::move(digest), true};
}

void send(const JobService& jobs, ImageWork& images, std::string_view type, const Request& request,
          Response& response, Exchange& exchange) {
    auto file = images.run([&]() -> Result<ResultFile> {
        const auto query = query_of(request);
        if (!query) return tl::unexpected(query.error());
        const auto comparison = compare(jobs, *query);
        if (!comparison) return tl::unexpected(comparison.error());
        return file_of(*comparison, type);
    });
    if (!file) return send_problem(response, file.error(), exchange.request_id);
    send_representation(request, response, representation_of(std::move(*file)), exchange);
}

}  // namespace

void add_compare_routes(Router& router, const JobService& jobs, ImageWork& images) {
    router.get(
        "/v1/compare",
        [&jobs, &images](const Request& request, Response& response, Exchange& exchange) {
            const auto chosen = choose_type(request, response, kTypes, exchange.request_id);
            if (chosen) send(jobs, images, kTypes[*chosen], request, response, exchange);
        },
        Query::Read);
    router.get(
        "/v1/compare\\.png",
        [&jobs, &images](const Request& request, Response& response, Exchange& exchange) {
            send(jobs, images, "image/png", request, response, exchange);
        },
        Query::Read);
}

}  // namespace bouguer::server
