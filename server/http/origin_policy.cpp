// SPDX-License-Identifier: Apache-2.0
#include "server/http/origin_policy.h"

#include <algorithm>

#include "server/http/field_syntax.h"

namespace bouguer::server {
namespace {

std::optional<int> default_port(std::string_view scheme) {
    if (equal_ignoring_case(scheme, "http")) return 80;
    if (equal_ignoring_case(scheme, "https")) return 443;
    return std::nullopt;
}

}  // namespace

bool may_read(const std::vector<std::string>& allowed, std::string_view origin) {
    return may_change(allowed, origin) ||
           std::find(allowed.begin(), allowed.end(), "*") != allowed.end();
}

bool may_change(const std::vector<std::string>& allowed, std::string_view origin) {
    return origin != "*" && std::find(allowed.begin(), allowed.end(), origin) != allowed.end();
}

bool is_same_origin(std::string_view origin, const std::optional<Authority>& server) {
    const auto scheme_end = origin.find("://");
    if (scheme_end == std::string_view::npos || !server) return false;
    const auto port = default_port(origin.substr(0, scheme_end));
    const auto page = authority_from(origin.substr(scheme_end + 3));
    return port && page && page->host == server->host &&
           page->port.value_or(*port) == server->port.value_or(*port);
}

}  // namespace bouguer::server
