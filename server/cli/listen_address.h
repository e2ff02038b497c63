// SPDX-License-Identifier: Apache-2.0
// Where the daemon listens: "HOST:PORT".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace bouguer::server {

struct ListenAddress {
    std::string host;  ///< without the brackets of an IPv6 address
    int port = 0;
};

/// Empty when `text` is not HOST:PORT, or [IPv6]:PORT, with a port in [0, 65535].
[[nodiscard]] std::optional<ListenAddress> listen_address_from(std::string_view text);

/// "http://127.0.0.1:8080".
[[nodiscard]] std::string url_of(const ListenAddress& address);

}  // namespace bouguer::server
