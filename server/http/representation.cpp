// SPDX-License-Identifier: Apache-2.0
#include "server/http/representation.h"

#include "api/digest.h"
#include "server/http/byte_range.h"
#include "server/http/conditions.h"
#include "server/http/negotiation.h"
#include "server/http/problems.h"

namespace bouguer::server {
namespace {

/// If-Range compares strongly, and a date never matches: there is no Last-Modified here.
bool range_applies(const httplib::Request& request, const std::string& tag) {
    return !request.has_header("If-Range") || request.get_header_value("If-Range") == tag;
}

Content part_of(const Content& whole, ByteRange range, httplib::Response& response) {
    response.status = 206;
    response.set_header("Content-Range", "bytes " + std::to_string(range.first) + '-' +
                                             std::to_string(range.first + range.length - 1) + '/' +
                                             std::to_string(whole.size()));
    return whole.part(range.first, range.length);
}

}  // namespace

std::string quoted_tag(const Representation& representation) {
    return '"' + representation.tag + '"';
}

Representation representation_of(ResultFile file) {
    return {.content = std::move(file.content),
            .media_type = std::move(file.media_type),
            .tag = std::move(file.digest),
            .immutable = file.final,
            .ranges = true};
}

Representation json_representation(std::string json) {
    return made_representation(std::move(json), "application/json");
}

Representation made_representation(std::string bytes, std::string media_type) {
    std::string tag = api::sha256_hex(bytes).substr(0, 32);
    return {.content = std::move(bytes),
            .media_type = std::move(media_type),
            .tag = std::move(tag),
            .immutable = false,
            .ranges = false};
}

std::optional<std::size_t> choose_type(const httplib::Request& request, httplib::Response& response,
                                       std::span<const std::string_view> types,
                                       std::string_view request_id) {
    response.set_header("Vary", "Accept");
    const auto chosen = negotiate(request.get_header_value("Accept"), types);
    if (!chosen) {
        send_problem(response,
                     Refusal{406, "not-acceptable", "None of the accepted types is on offer."},
                     request_id);
    }
    return chosen;
}

void send_representation(const httplib::Request& request, httplib::Response& response,
                         Representation representation, Exchange& exchange) {
    const std::string tag = quoted_tag(representation);
    response.status = 200;
    response.set_header("ETag", tag);
    response.set_header("Cache-Control",
                        representation.immutable ? "max-age=31536000, immutable" : "no-cache");
    if (representation.ranges) response.set_header("Accept-Ranges", "bytes");
    if (!if_match_holds(request, tag)) {  // first of all [RFC 9110 §13.2.2]
        return send_problem(response, precondition_failed(), exchange.request_id);
    }
    if (if_none_match_names(request, tag)) {
        response.status = 304;
        return;
    }
    RangeRequest wanted;
    if (representation.ranges && request.method == "GET" && range_applies(request, tag)) {
        wanted =
            parse_range_field(request.get_header_value("Range"), representation.content.size());
    }
    if (wanted.kind == RangeRequest::Kind::NotSatisfiable) {
        response.set_header("Content-Range",
                            "bytes */" + std::to_string(representation.content.size()));
        return send_problem(
            response, Refusal{416, "range-not-satisfiable", "The range begins behind the end."},
            exchange.request_id);
    }
    response.set_header("Content-Type", representation.media_type);
    if (wanted.kind == RangeRequest::Kind::Part) {
        representation.content = part_of(representation.content, wanted.range, response);
    }
    exchange.content = std::move(representation.content);
}

}  // namespace bouguer::server
