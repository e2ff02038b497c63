// SPDX-License-Identifier: Apache-2.0
// Who counts as one client when shares are given out.
#pragma once

#include <string>

namespace bouguer::server {

/// The same for all addresses that one client can easily have: an IPv4 address is a client, of an
/// IPv6 address its first 64 bits are [RFC 4291 §2.5.1]: "192.0.2.1", "2001:db8::/64". An IPv4
/// address mapped into IPv6 is itself. What is no address is returned as it is.
[[nodiscard]] std::string client_key(const std::string& numeric_address);

}  // namespace bouguer::server
