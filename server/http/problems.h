// SPDX-License-Identifier: Apache-2.0
// Problem answers [RFC 9457] from routes.
#pragma once

#include <httplib.h>

#include <string_view>

#include "renderer/core/result.h"
#include "server/http/request_head.h"

namespace bouguer::server {

/// Seconds after which a Busy may be tried again where nothing better is known: what makes the
/// service busy for a moment (others who validate, compare, convert) is over within it.
inline constexpr int kShortRetry_s = 5;

/// An Error of the service or the documents; the status follows from its kind. `retry_after_s` is
/// told to those who find the service busy or its storage at fault.
void send_problem(httplib::Response& response, const Error& error, std::string_view request_id,
                  int retry_after_s = kShortRetry_s);
/// What HTTP itself refuses.
void send_problem(httplib::Response& response, const Refusal& refusal, std::string_view request_id);
/// 404 for something that no one has.
void send_not_found(httplib::Response& response, std::string_view request_id);

}  // namespace bouguer::server
