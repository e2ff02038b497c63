// SPDX-License-Identifier: Apache-2.0
// Lines to a file descriptor whose reader may be slow, stopped or gone: whoever adds one never
// waits for it.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <thread>

namespace bouguer::server {

struct LineWriterOptions {
    std::size_t bytes = 1U << 20U;  ///< of lines that wait, from when on new ones are dropped
    /// What the destructor gives the reader to take what still waits.
    std::chrono::milliseconds patience{500};
};

/// Writes on a thread of its own. Lines that find no room, or that the system refuses to write, are
/// dropped and counted, and as soon as there is room again a line says how many. add() is
/// thread-safe.
///
/// The descriptor is shared with other processes, so it is not made non-blocking: the thread waits
/// until the system says that there is room and then writes no more than a pipe takes at once
/// (PIPE_BUF). Where another process takes that room first it may hang all the same: the destructor
/// leaves it behind then, which harms nothing since what it uses is its own.
class LineWriter {
  public:
    /// The line that tells of `dropped` others, with its line feed. From the writer's thread.
    using DropNote = std::function<std::string(std::uint64_t dropped)>;

    /// `fd` stays with the caller and is not closed.
    LineWriter(int fd, DropNote note, LineWriterOptions options = {});
    ~LineWriter();
    LineWriter(const LineWriter&) = delete;
    LineWriter& operator=(const LineWriter&) = delete;

    /// `line` with its line feed. Never waits for the reader.
    void add(std::string line);

  private:
    struct State;
    class Work;

    const LineWriterOptions options_;
    const std::shared_ptr<State> state_;  ///< of the thread, too, which may outlive this
    std::thread thread_;
};

}  // namespace bouguer::server
