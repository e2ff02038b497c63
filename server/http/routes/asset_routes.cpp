// SPDX-License-Identifier: Apache-2.0
#include "server/http/routes/asset_routes.h"

#include <algorithm>

#include "api/digest_list.h"
#include "api/json_builder.h"
#include "server/http/conditions.h"
#include "server/http/problems.h"
#include "server/http/representation.h"

namespace bouguer::server {
namespace {

using httplib::Request;
using httplib::Response;

void set_json(Response& response, int status, std::string json) {
    response.status = status;
    response.body = std::move(json);
    response.set_header("Content-Type", "application/json");
}

/// PUT /v1/assets/{digest} -> 201 the first time, 200 from then on.
void put(AssetStore& assets, const Request& request, Response& response, Exchange& exchange) {
    const std::string digest = request.matches[1];
    if (has_conditions(request)) {
        const auto tag = assets.has(digest) ? std::optional('"' + digest + '"') : std::nullopt;
        const auto refused = refused_by_condition(request, tag);
        if (refused) return send_problem(response, *refused, exchange.request_id);
    }
    const auto stored = assets.put(digest, request.body);
    if (!stored) return send_problem(response, stored.error(), exchange.request_id);
    const bool is_new = *stored == AssetStore::Put::New;
    if (is_new) response.set_header("Location", "/v1/assets/" + digest);
    set_json(response, is_new ? 201 : 200,
             api::JsonObject()
                 .set("digest", digest)
                 .set("media_type", asset_media_type(request.body))
                 .set("bytes", request.body.size())
                 .text());
}

/// GET /v1/assets/{digest}
void read(const AssetStore& assets, const Request& request, Response& response,
          Exchange& exchange) {
    const std::string digest = request.matches[1];
    auto bytes = assets.get(digest);
    if (!bytes) return send_problem(response, bytes.error(), exchange.request_id);
    const std::string media_type(asset_media_type(*bytes));
    send_representation(request, response,
                        {.content = std::move(*bytes),
                         .media_type = media_type,
                         .tag = digest,
                         .immutable = true,
                         .ranges = true},
                        exchange);
}

/// POST /v1/assets/missing: which of the digests have not been put yet.
void missing(const AssetStore& assets, const Request& request, Response& response,
             Exchange& exchange) {
    auto digests = api::parse_digest_list(request.body, api::Limits());
    if (!digests) return send_problem(response, digests.error(), exchange.request_id);
    std::erase_if(*digests, [&](const std::string& digest) { return assets.has(digest); });
    set_json(response, 200, api::missing_json(*digests));
}

}  // namespace

void add_asset_routes(Router& router, AssetStore& assets) {
    const std::string path = "/v1/assets/(sha256-[0-9a-f]{64})";
    router.put(path, [&assets](const Request& request, Response& response, Exchange& exchange) {
        put(assets, request, response, exchange);
    });
    router.get(path, [&assets](const Request& request, Response& response, Exchange& exchange) {
        read(assets, request, response, exchange);
    });
    router.post("/v1/assets/missing",
                [&assets](const Request& request, Response& response, Exchange& exchange) {
                    missing(assets, request, response, exchange);
                });
}

}  // namespace bouguer::server
