// SPDX-License-Identifier: Apache-2.0
// SIGINT and SIGTERM as something to wait for, not as interruptions.
#pragma once

namespace bouguer::server {

/// Holds back SIGINT and SIGTERM in this thread and in all that it starts from now on. One object a
/// program, made before any thread.
class StopSignal {
  public:
    StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    /// Waits until one comes. After the first, another ends the program at once.
    void wait();
    /// Whether one has come since the start, without waiting.
    [[nodiscard]] bool has_come();

  private:
    void let_the_next_one_kill();
    bool has_come_ = false;
};

}  // namespace bouguer::server
