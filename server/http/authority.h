// SPDX-License-Identifier: Apache-2.0
// Whom a request is for: the host and port of a Host field, of a target or of an origin.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace bouguer::server {

struct Authority {
    std::string host;  ///< lower case; without the brackets of an IPv6 address, or a last dot
    std::optional<int> port;  ///< empty: that of the scheme
    bool operator==(const Authority&) const = default;
};

/// "host", "host:port", "[v6]" or "[v6]:port" [RFC 3986 §3.2] with a port in [0, 65535]. Empty when
/// it is none of these, or names a user, or has percent-encoded parts: no host here needs them.
[[nodiscard]] std::optional<Authority> authority_from(std::string_view text);

/// Whether `host` is an address and not a name: "10.0.0.1", "::1".
[[nodiscard]] bool is_address(const std::string& host);

/// Whether only this machine can be meant: 127.0.0.0/8, ::1 and "localhost".
[[nodiscard]] bool is_loopback(std::string_view host);

}  // namespace bouguer::server
