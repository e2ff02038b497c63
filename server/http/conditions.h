// SPDX-License-Identifier: Apache-2.0
// Conditional requests [RFC 9110 §13]. There is no Last-Modified here: dates are no conditions.
#pragma once

#include <httplib.h>

#include <optional>
#include <string>

#include "server/http/request_head.h"

namespace bouguer::server {

/// Whether If-Match lets the request go on [§13.1.1]: it is not there, "*", or names `tag` (the
/// current one, strong, with its quotes; strong comparison).
[[nodiscard]] bool if_match_holds(const httplib::Request& request, const std::string& tag);

/// Whether If-None-Match is "*" or names `tag`, by weak comparison [§13.1.2].
[[nodiscard]] bool if_none_match_names(const httplib::Request& request, const std::string& tag);

/// What is answered when If-Match does not hold: 412.
[[nodiscard]] Refusal precondition_failed();

/// Whether the request asks for either.
[[nodiscard]] bool has_conditions(const httplib::Request& request);

/// For a request that would change something: its refusal when a condition does not hold. `tag` is
/// that of what is there now, empty when there is nothing.
[[nodiscard]] std::optional<Refusal> refused_by_condition(const httplib::Request& request,
                                                          const std::optional<std::string>& tag);

}  // namespace bouguer::server
