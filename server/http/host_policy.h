// SPDX-License-Identifier: Apache-2.0
// Under which names the service may be asked. Against DNS rebinding: a page of evil.example whose
// name is made to lead to this machine has the same origin as we do, in the eyes of the browser,
// but its requests carry Host: evil.example.
#pragma once

#include <string>
#include <vector>

#include "server/http/authority.h"
#include "server/http/request_head.h"

namespace bouguer::server {

/// Immutable and thread-safe.
class HostPolicy {
  public:
    /// For a server that listens on `host` (as it was told to) and `port` (as it was bound).
    ///
    /// On a loopback address: "localhost" and loopback addresses, with this port, and `allowed`.
    /// On any other: every address, "localhost", `host` and `allowed`, with any port, since what
    /// publishes it (a container's engine, a forwarding) may do so under another one. An address is
    /// never the name of a page elsewhere; names are, so they have to be allowed one by one.
    HostPolicy(const std::string& host, int port, std::vector<Authority> allowed);

    /// Whether the request is for us. Without a host (HTTP/1.0) it is: no browser asks so.
    [[nodiscard]] bool allows(const RequestHead& head) const;
    [[nodiscard]] bool allows(const Authority& authority) const;

  private:
    bool is_local_;
    int port_;
    std::vector<Authority> allowed_;  ///< an entry without a port is for every port
};

}  // namespace bouguer::server
