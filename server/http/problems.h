// SPDX-License-Identifier: Apache-2.0
// Problem answers [RFC 9457] from routes.
#pragma once

#include <httplib.h>

#include <string_view>

#include "renderer/core/result.h"
#include "server/http/request_head.h"

namespace bouguer::server {

/// An Error of the service or the documents; the status follows from its kind.
void send_problem(httplib::Response& response, const Error& error, std::string_view request_id);
/// What HTTP itself refuses.
void send_problem(httplib::Response& response, const Refusal& refusal, std::string_view request_id);
/// 404 for something that no one has.
void send_not_found(httplib::Response& response, std::string_view request_id);

}  // namespace bouguer::server
