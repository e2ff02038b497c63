// SPDX-License-Identifier: Apache-2.0
// Whole answers as bytes, for what is said without a route: refusals, overload, health.
#pragma once

#include <string>
#include <string_view>

#include "server/http/request_head.h"

namespace bouguer::server {

/// "Not Found" for 404; "" for codes that are not used here.
[[nodiscard]] std::string_view reason_phrase(int status);

/// The present time as in a Date field [RFC 9110 §5.6.7].
[[nodiscard]] std::string http_date();

/// application/problem+json [RFC 9457] for what HTTP itself refuses, where there is no Error to
/// map.
[[nodiscard]] std::string problem_text(const Refusal& refusal, std::string_view request_id);

struct PlainAnswer {
    int status = 200;
    std::string_view content_type = "application/json";
    std::string body;
    std::string_view request_id;
    int retry_after_s = 0;  ///< 0: no Retry-After
    bool close = false;
    bool head_only = false;  ///< for HEAD: the fields without the body
};

[[nodiscard]] std::string to_bytes(const PlainAnswer& answer);

/// The bytes that refuse a request and announce the close.
[[nodiscard]] std::string refusal_bytes(const Refusal& refusal, std::string_view request_id);

}  // namespace bouguer::server
