// SPDX-License-Identifier: Apache-2.0
// Which web pages may call the API [Fetch standard, CORS protocol].
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/http/authority.h"

namespace bouguer::server {

/// Whether a page of `origin` may read answers: it is listed, or "*" is.
[[nodiscard]] bool may_read(const std::vector<std::string>& allowed, std::string_view origin);

/// Whether a page of `origin` may submit, cancel and delete: it is listed by itself. "*" does not
/// count: with it every page that anybody on this machine looks at could.
[[nodiscard]] bool may_change(const std::vector<std::string>& allowed, std::string_view origin);

/// Whether `origin` ("https://host:port") is the server that the request was sent to: the same host
/// and port, where a port that is left out is that of the origin's scheme. Of the scheme we know
/// nothing: a proxy before us may have ended TLS.
[[nodiscard]] bool is_same_origin(std::string_view origin, const std::optional<Authority>& server);

}  // namespace bouguer::server
