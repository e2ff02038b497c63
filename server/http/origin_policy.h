// SPDX-License-Identifier: Apache-2.0
// Which web pages may call the API [Fetch standard, CORS protocol].
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bouguer::server {

/// Whether a page of `origin` may read answers: it is listed, or "*" is.
[[nodiscard]] bool is_listed_origin(const std::vector<std::string>& allowed,
                                    std::string_view origin);

/// Whether `origin` ("https://host:port") is the server that the request was sent to, by its Host
/// field. The scheme is not compared: a proxy before us may have ended TLS.
[[nodiscard]] bool is_same_origin(std::string_view origin, std::string_view host);

}  // namespace bouguer::server
