// SPDX-License-Identifier: Apache-2.0
// The listening socket.
#pragma once

#include <string>

#include "renderer/core/result.h"
#include "server/file_descriptor.h"

namespace bouguer::server {

/// A client's socket (non-blocking, close-on-exec, no Nagle delay) and its numeric address.
struct Accepted {
    FileDescriptor fd;
    std::string client;
};

/// Why there is no client.
enum class NoClient {
    NoneWaits,      ///< or the one that waited has gone
    OutOfResources  ///< of descriptors or memory: the client waits on, until there are some again
};

class Listener {
  public:
    /// Binds `host` (name or numeric address) and `port` (0: any free one). A second daemon on the
    /// same port is refused. Error{Internal} with the system's reason.
    [[nodiscard]] static Result<Listener> open(const std::string& host, int port);

    [[nodiscard]] tl::expected<Accepted, NoClient> accept();

    [[nodiscard]] int fd() const { return socket_.get(); }
    [[nodiscard]] int port() const { return port_; }

  private:
    FileDescriptor socket_;
    int port_ = 0;
};

}  // namespace bouguer::server
