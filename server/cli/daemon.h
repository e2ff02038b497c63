// SPDX-License-Identifier: Apache-2.0
// The parts of a running daemon, put together from the options of `bouguer serve`.
#pragma once

#include <memory>

#include "renderer/core/result.h"
#include "server/cli/listen_address.h"
#include "server/cli/options.h"

namespace bouguer::server {

/// Serves and renders from start() to the end of its life. Used by one thread.
class Daemon {
  public:
    /// Opens the data folder, takes up the jobs that wait there and listens on `address`.
    /// Error{Internal}: the folder, the store or the address cannot be used.
    [[nodiscard]] static Result<Daemon> start(const ServeOptions& options,
                                              const ListenAddress& address);
    ~Daemon();
    Daemon(Daemon&& other) noexcept;
    Daemon& operator=(Daemon&& other) noexcept;

    /// The port that was bound.
    [[nodiscard]] int port() const;

    /// That of the listener for health; 0: there is none.
    [[nodiscard]] int health_port() const;

    /// Takes no more jobs and says so in /readyz, but serves on: for those who send clients here to
    /// see it and send them elsewhere.
    void refuse_new_jobs();
    /// As refuse_new_jobs(); then ends what is under way and puts running jobs back into the queue.
    void drain();

  private:
    struct Parts;
    explicit Daemon(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace bouguer::server
