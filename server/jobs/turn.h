// SPDX-License-Identifier: Apache-2.0
// Bounds on work that is costly: who comes when enough are at it is refused, and does not wait.
#pragma once

#include <atomic>

namespace bouguer::server {

/// Counts a thread as busy with something of which only a few may run.
class Turn {
  public:
    explicit Turn(std::atomic<int>& count) : count_(count), number_(++count) {}
    ~Turn() { --count_; }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;
    [[nodiscard]] bool is_within(int limit) const { return number_ <= limit; }

  private:
    std::atomic<int>& count_;
    const int number_;
};

}  // namespace bouguer::server
