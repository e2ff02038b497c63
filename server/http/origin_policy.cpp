// SPDX-License-Identifier: Apache-2.0
#include "server/http/origin_policy.h"

#include <algorithm>

namespace bouguer::server {

bool is_listed_origin(const std::vector<std::string>& allowed, std::string_view origin) {
    return std::any_of(allowed.begin(), allowed.end(),
                       [&](const std::string& a) { return a == "*" || a == origin; });
}

bool is_same_origin(std::string_view origin, std::string_view host) {
    const auto scheme_end = origin.find("://");
    return scheme_end != std::string_view::npos && origin.substr(scheme_end + 3) == host;
}

}  // namespace bouguer::server
