// SPDX-License-Identifier: Apache-2.0
// Sending what has an entity tag: content negotiation, conditional requests and ranges
// [RFC 9110 §12, §13, §14].
#pragma once

#include <httplib.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "server/http/exchange.h"
#include "server/jobs/job_service.h"

namespace bouguer::server {

struct Representation {
    Content content;
    std::string media_type;
    std::string tag;  ///< of the entity tag, without quotes; strong
    bool immutable = false;
    bool ranges = false;  ///< whether parts may be asked for
};

/// As in ETag.
[[nodiscard]] std::string quoted_tag(const Representation& representation);

/// 200, 206, 304, 412 or 416, as the request's If-Match, If-None-Match, Range and If-Range ask. The
/// content goes into the exchange and not through the HTTP library, which would hold all of it.
void send_representation(const httplib::Request& request, httplib::Response& response,
                         Representation representation, Exchange& exchange);

/// Which of the media types is to be sent, as Accept asks. Empty: a 406 has been.
[[nodiscard]] std::optional<std::size_t> choose_type(const httplib::Request& request,
                                                     httplib::Response& response,
                                                     std::span<const std::string_view> types,
                                                     std::string_view request_id);

/// A result file: its digest is the tag, and parts may be asked for.
[[nodiscard]] Representation representation_of(ResultFile file);
/// Bytes made for this answer, tagged by their content.
[[nodiscard]] Representation made_representation(std::string bytes, std::string media_type);
[[nodiscard]] Representation json_representation(std::string json);

}  // namespace bouguer::server
