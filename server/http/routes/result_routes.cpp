// SPDX-License-Identifier: Apache-2.0
#include "server/http/routes/result_routes.h"

#include <array>
#include <span>

#include "server/http/negotiation.h"
#include "server/http/problems.h"
#include "server/http/representation.h"
#include "server/http/routes/job_id_pattern.h"

namespace bouguer::server {
namespace {

using httplib::Request;
using httplib::Response;

/// A path below the job and the file that it names.
struct NamedResult {
    const char* path;
    const char* file;
};
constexpr std::array kNamed{
    NamedResult{"/image\\.png", "image.png"}, NamedResult{"/image\\.exr", "image.exr"},
    NamedResult{"/report", "report.json"},    NamedResult{"/error\\.json", "error.json"},
    NamedResult{"/error\\.csv", "error.csv"}, NamedResult{"/plan", "plan.json"},
    NamedResult{"/health", "health.json"},
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
};

void send_file(const JobService& jobs, const std::string& name, const Request& request,
               Response& response, const Exchange& exchange) {
    auto file = jobs.file(request.matches[1], name);
    if (!file) return send_problem(response, file.error(), exchange.request_id);
    send_representation(request, response, representation_of(std::move(*file)),
                        exchange.request_id);
}

void send_negotiated(const JobService& jobs, std::span<const Offer> offers, const Request& request,
                     Response& response, const Exchange& exchange) {
    std::vector<std::string_view> types;
    for (const Offer& offer : offers) types.push_back(offer.media_type);
    const auto chosen = negotiate(request.get_header_value("Accept"), types);
    response.set_header("Vary", "Accept");
    if (!chosen) {
        return send_problem(
            response, Refusal{406, "not-acceptable", "None of the accepted types is on offer."},
            exchange.request_id);
    }
    send_file(jobs, std::string(offers[*chosen].file), request, response, exchange);
}

}  // namespace

void add_result_routes(Router& router, const JobService& jobs) {
    for (const NamedResult& result : kNamed) {
        router.get(job_path(result.path),
                   [&jobs, file = std::string(result.file)](
                       const Request& request, Response& response, Exchange& exchange) {
                       send_file(jobs, file, request, response, exchange);
                   });
    }
    router.get(job_path("/image"),
               [&jobs](const Request& request, Response& response, Exchange& exchange) {
                   send_negotiated(jobs, kImageOffers, request, response, exchange);
               });
    router.get(job_path("/error"),
               [&jobs](const Request& request, Response& response, Exchange& exchange) {
                   send_negotiated(jobs, kErrorOffers, request, response, exchange);
               });
}

}  // namespace bouguer::server
