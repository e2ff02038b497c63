// SPDX-License-Identifier: Apache-2.0
// Where a job's events wait until the thread that owns the client's socket takes them.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "server/jobs/job_service.h"

namespace bouguer::server {

/// Thread-safe and bounded: of progress events only the newest is kept, and a client that does not
/// take the others is given up.
class EventInbox {
  public:
    using Clock = std::chrono::steady_clock;

    EventInbox(std::chrono::milliseconds progress_interval, std::size_t capacity_bytes)
        : progress_interval_(progress_interval), capacity_bytes_(capacity_bytes) {}

    /// The listener of the subscription. Never blocks for long, never throws but for memory.
    void push(const JobEvent& event);

    /// `wake` is called after a push that needs attention, from the thread that pushed, with no
    /// lock held; at once if something is there already.
    void on_push(std::function<void()> wake);

    struct Taken {
        std::string text;       ///< what may be sent now, as text/event-stream
        bool pending = false;   ///< a progress event waits for its interval to pass
        bool ended = false;     ///< "done" was in this text or a former one
        bool overflow = false;  ///< more came than capacity_bytes: give the client up
    };
    [[nodiscard]] Taken take(Clock::time_point now);

  private:
    const std::chrono::milliseconds progress_interval_;
    const std::size_t capacity_bytes_;
    mutable std::mutex mutex_;
    // guarded by mutex_
    std::function<void()> wake_;
    std::string ready_;                    ///< to be sent at once
    std::optional<std::string> progress_;  ///< the newest, formatted
    Clock::time_point last_progress_{};
    bool notified_ = false;  ///< the owner was woken and has not taken yet
    bool ended_ = false;
    bool overflow_ = false;
};

/// The id under which every "done" event goes out. A word, because numbers begin anew with the
/// process: a client that comes back with it has seen the end, whichever process told it.
inline constexpr std::string_view kDoneEventId = "done";

/// One event as text/event-stream [HTML §9.2.6]. `data` is one line. The first, "snapshot", also
/// says how long a browser is to wait before it opens a broken stream again.
[[nodiscard]] std::string to_event_text(const JobEvent& event);

}  // namespace bouguer::server
