// SPDX-License-Identifier: Apache-2.0
#include "server/http/event_inbox.h"

namespace bouguer::server {

namespace {
constexpr std::string_view kRetry = "retry: 2000\n";  // milliseconds
}

std::string to_event_text(const JobEvent& event) {
    std::string text;
    if (event.type == "snapshot") text += kRetry;
    text += "id: ";
    text += event.type == "done" ? std::string(kDoneEventId) : std::to_string(event.id);
    text += "\nevent: " + event.type + "\ndata: " + event.data + "\n\n";
    return text;
}

void EventInbox::push(const JobEvent& event) {
    std::function<void()> wake;
    {
        const std::lock_guard lock(mutex_);
        if (ended_ || overflow_) return;
        if (event.type == "progress") {
            progress_ = to_event_text(event);
        } else {
            // what was held back goes first, so that ids grow
            if (progress_) ready_ += *std::exchange(progress_, std::nullopt);
            ready_ += to_event_text(event);
            ended_ = event.type == "done";
        }
        overflow_ = ready_.size() > capacity_bytes_;
        if (!notified_ && wake_) {
            notified_ = true;
            wake = wake_;
        }
    }
    if (wake) wake();
}

void EventInbox::on_push(std::function<void()> wake) {
    bool now = false;
    {
        const std::lock_guard lock(mutex_);
        wake_ = wake;
        now = notified_ = !ready_.empty() || progress_ || ended_ || overflow_;
    }
    if (now) wake();
}

EventInbox::Taken EventInbox::take(Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    Taken taken{.text = std::exchange(ready_, {}), .ended = ended_, .overflow = overflow_};
    if (progress_ && now - last_progress_ >= progress_interval_) {
        taken.text += *std::exchange(progress_, std::nullopt);
        last_progress_ = now;
    }
    // while a progress event waits the owner looks again by itself
    taken.pending = notified_ = progress_.has_value();
    return taken;
}

}  // namespace bouguer::server
