// SPDX-License-Identifier: Apache-2.0
#include "server/http/routes/result_routes.h"

#include <array>
#include <span>

#include "server/http/problems.h"
#include "server/http/query.h"
#include "server/http/representation.h"
#include "server/http/routes/job_id_pattern.h"
#include "server/jobs/job_film.h"
#include "server/jobs/result_files.h"

namespace bouguer::server {
namespace {

using httplib::Request;
using httplib::Response;

struct ResultContext {
    const JobService& jobs;
    ImageWork& images;
};

/// A path below the job and the file that it names.
struct NamedResult {
    const char* path;
    const char* file;
};
constexpr std::array kNamed{
    NamedResult{"/image\\.png", "image.png"}, NamedResult{"/image\\.exr", "image.exr"},
    NamedResult{"/report", "report.json"},    NamedResult{"/error\\.json", "error.json"},
    NamedResult{"/error\\.csv", "error.csv"}, NamedResult{"/error\\.png", "error.png"},
    NamedResult{"/plan", "plan.json"},        NamedResult{"/health", "health.json"},
};

/// A path below the job whose file is chosen by Accept: media types and the files for them.
struct Offer {
    std::string_view media_type, file;
};
constexpr std::array kImageOffers{
    Offer{"image/png", "image.png"},
    Offer{"image/x-exr", "image.exr"},
    Offer{"image/exr", "image.exr"},
};
constexpr std::array kErrorOffers{
    Offer{"application/json", "error.json"},
    Offer{"text/csv", "error.csv"},
    Offer{"image/png", "error.png"},
};

/// The file as it is kept, or, where the query asks for another image, that one.
Result<ResultFile> file_as_asked(const ResultContext& context, const std::string& name,
                                 const Request& request) {
    const JobId id = request.matches[1];
    if (!is_image(name)) return context.jobs.file(id, name);
    const auto query = query_of(request);
    if (!query) return tl::unexpected(query.error());
    if (query->empty()) return context.jobs.file(id, name);
    auto made = context.images.run([&] { return image_anew(context.jobs, id, name, *query); });
    // Of problems by name only the reader of the query knows.
    if (!made && !made.error().problems.empty()) return tl::unexpected(bad_query(made.error()));
    return made;
}

void send_file(const ResultContext& context, const std::string& name, const Request& request,
               Response& response, Exchange& exchange) {
    auto file = file_as_asked(context, name, request);
    if (!file) return send_problem(response, file.error(), exchange.request_id);
    send_representation(request, response, representation_of(std::move(*file)), exchange);
}

void send_negotiated(const ResultContext& context, std::span<const Offer> offers,
                     const Request& request, Response& response, Exchange& exchange) {
    std::vector<std::string_view> types;
    for (const Offer& offer : offers) types.push_back(offer.media_type);
    const auto chosen = choose_type(request, response, types, exchange.request_id);
    if (!chosen) return;
    send_file(context, std::string(offers[*chosen].file), request, response, exchange);
}

}  // namespace

void add_result_routes(Router& router, const JobService& jobs, ImageWork& images) {
    const ResultContext context{jobs, images};
    for (const NamedResult& result : kNamed) {
        router.get(
            job_path(result.path),
            [context, file = std::string(result.file)](const Request& request, Response& response,
                                                       Exchange& exchange) {
                send_file(context, file, request, response, exchange);
            },
            is_image(result.file) ? Query::Read : Query::Ignored);
    }
    router.get(
        job_path("/image"),
        [context](const Request& request, Response& response, Exchange& exchange) {
            send_negotiated(context, kImageOffers, request, response, exchange);
        },
        Query::Read);
    router.get(
        job_path("/error"),
        [context](const Request& request, Response& response, Exchange& exchange) {
            send_negotiated(context, kErrorOffers, request, response, exchange);
        },
        Query::Ignored);
}

}  // namespace bouguer::server
