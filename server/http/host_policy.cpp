// SPDX-License-Identifier: Apache-2.0
#include "server/http/host_policy.h"

#include <algorithm>

namespace bouguer::server {
namespace {

constexpr int kHttpPort = 80, kHttpsPort = 443;

/// Left out, the port is that of the scheme, and a proxy before us may have ended TLS.
bool has_port(const Authority& authority, int port) {
    if (authority.port) return *authority.port == port;
    return port == kHttpPort || port == kHttpsPort;
}

}  // namespace

HostPolicy::HostPolicy(const std::string& host, int port, std::vector<Authority> allowed)
    : is_local_(is_loopback(host)), port_(port), allowed_(std::move(allowed)) {
    if (is_local_) return;
    allowed_.push_back({"localhost", std::nullopt});
    if (auto own = authority_from(host)) allowed_.push_back(std::move(*own));
}

bool HostPolicy::allows(const Authority& authority) const {
    // our own port without TLS: a port that is left out is 80
    if (is_local_ && is_loopback(authority.host) && authority.port.value_or(kHttpPort) == port_) {
        return true;
    }
    if (!is_local_ && is_address(authority.host)) return true;
    return std::any_of(allowed_.begin(), allowed_.end(), [&](const Authority& a) {
        return a.host == authority.host && (!a.port || has_port(authority, *a.port));
    });
}

bool HostPolicy::allows(const RequestHead& head) const {
    return !head.authority || allows(*head.authority);
}

}  // namespace bouguer::server
