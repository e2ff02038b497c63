// SPDX-License-Identifier: Apache-2.0
// The listening socket.
#pragma once

#include <optional>
#include <string>

#include "renderer/core/result.h"
#include "server/file_descriptor.h"

namespace bouguer::server {

/// A client's socket (non-blocking, close-on-exec, no Nagle delay) and its numeric address.
struct Accepted {
    FileDescriptor fd;
    std::string client;
};

class Listener {
  public:
    /// Binds `host` (name or numeric address) and `port` (0: any free one). A second daemon on the
    /// same port is refused. Error{Internal} with the system's reason.
    [[nodiscard]] static Result<Listener> open(const std::string& host, int port);

    /// The next client; empty when none waits. Out of descriptors, the client is turned away and
    /// the listener lives on.
    [[nodiscard]] std::optional<Accepted> accept();

    [[nodiscard]] int fd() const { return socket_.get(); }
    [[nodiscard]] int port() const { return port_; }

  private:
    void turn_away();

    FileDescriptor socket_;
    FileDescriptor spare_;  ///< given up for a moment to turn a client away
    int port_ = 0;
};

}  // namespace bouguer::server
