// SPDX-License-Identifier: Apache-2.0
// A listening socket in an epoll set. Out of descriptors it rests for a moment: the clients wait in
// the kernel's queue, and nobody spins.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "server/http/listener.h"

namespace bouguer::server {

/// One thread only. `epoll` outlives it.
class Door {
  public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds kRest{50};

    /// `id` is what the set tells when clients wait.
    Door(Listener listener, int epoll, std::uint64_t id);

    /// The next client; empty when none waits or there are no descriptors, and then the door rests.
    [[nodiscard]] std::optional<Accepted> accept(Clock::time_point now);
    [[nodiscard]] bool is_resting() const { return resting_until_.has_value(); }
    /// Ends the rest when it has lasted long enough.
    void look(Clock::time_point now);

    [[nodiscard]] int port() const { return listener_.port(); }

  private:
    void listen_for(std::uint32_t events) const;

    Listener listener_;
    int epoll_;
    std::uint64_t id_;
    std::optional<Clock::time_point> resting_until_;
};

}  // namespace bouguer::server
