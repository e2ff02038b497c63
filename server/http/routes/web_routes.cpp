// SPDX-License-Identifier: Apache-2.0
#include "server/http/routes/web_routes.h"

#include "api/openapi.h"
#include "server/http/representation.h"
#include "server/web/web_assets.h"

namespace bouguer::server {
namespace {

/// Nothing from elsewhere, no script or style inside the page, no frame around it.
constexpr const char* kContentSecurityPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// A literal path as a pattern.
std::string pattern_of(std::string_view path) {
    std::string pattern;
    for (const char c : path) {
        if (c == '.') pattern += '\\';
        pattern += c;
    }
    return pattern;
}

void add_asset(Router& router, const WebAsset& asset) {
    Representation representation = json_representation(std::string(asset.bytes));
    representation.media_type = asset.media_type;
    router.get(pattern_of(asset.path), [representation = std::move(representation)](
                                           const httplib::Request& request,
                                           httplib::Response& response, Exchange& exchange) {
        response.set_header("Content-Security-Policy", kContentSecurityPolicy);
        response.set_header("Referrer-Policy", "no-referrer");
        send_representation(request, response, representation, exchange);
    });
}

}  // namespace

void add_web_routes(Router& router) {
    for (const WebAsset& asset : web_assets()) add_asset(router, asset);
    add_asset(router, {"/v1/openapi.json", "application/json", api::openapi_json()});
}

}  // namespace bouguer::server
