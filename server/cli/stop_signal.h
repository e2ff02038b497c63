// SPDX-License-Identifier: Apache-2.0
// SIGINT and SIGTERM as something to wait for, not as interruptions; others that are not to kill.
#pragma once

namespace bouguer::server {

/// Holds back SIGINT and SIGTERM in this thread and in all that it starts from now on, until the
/// end of its life. One object a program, made before any thread.
class StopSignal {
  public:
    StopSignal();
    ~StopSignal();
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

/// Signals whose default is to kill and that mean nothing to a daemon: the terminal is gone
/// (SIGHUP), SIGUSR1, SIGUSR2. They are ignored as long as the object lives.
class IgnoredSignals {
  public:
    IgnoredSignals();
    ~IgnoredSignals();
    IgnoredSignals(const IgnoredSignals&) = delete;
    IgnoredSignals& operator=(const IgnoredSignals&) = delete;
};

}  // namespace bouguer::server
