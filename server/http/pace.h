// SPDX-License-Identifier: Apache-2.0
// The least rate of a transfer: how long a client may keep us waiting.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>

namespace bouguer::server {

/// A transfer begins with some time in hand; every byte buys more, at the least rate, and no more
/// than so much can be saved. Whoever stops is out of time after that much, whoever is slower than
/// the least rate a little later, and whoever is faster never.
class Pace {
  public:
    using Clock = std::chrono::steady_clock;
    struct Terms {
        std::chrono::milliseconds first{};  ///< time in hand at the beginning
        std::chrono::milliseconds most{};   ///< that can be in hand
        std::size_t bytes_per_second = 1;   ///< the least rate
    };

    Pace() = default;
    Pace(const Terms& terms, Clock::time_point now) : terms_(terms), deadline_(now + terms.first) {}

    void progress(std::size_t bytes, Clock::time_point now) {
        const std::chrono::microseconds bought(bytes * 1'000'000 / terms_.bytes_per_second);
        deadline_ = std::max(deadline_, std::min(deadline_ + bought, now + terms_.most));
    }
    /// The peer was not to blame for that long.
    void forgive(Clock::duration spent) { deadline_ += spent; }

    [[nodiscard]] Clock::time_point deadline() const { return deadline_; }

  private:
    Terms terms_;
    Clock::time_point deadline_;
};

}  // namespace bouguer::server
