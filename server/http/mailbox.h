// SPDX-License-Identifier: Apache-2.0
// Messages to a thread that sleeps in epoll.
#pragma once

#include <sys/eventfd.h>

#include <cstdint>
#include <mutex>
#include <utility>
#include <vector>

#include "server/file_descriptor.h"

namespace bouguer::server {

/// Any thread posts, one takes. Readable (level-triggered) while something is there.
template <class Message>
class Mailbox {
  public:
    Mailbox() : event_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}

    void post(Message message) {
        bool was_empty = false;
        {
            const std::lock_guard lock(mutex_);
            was_empty = messages_.empty();
            messages_.push_back(std::move(message));
        }
        if (was_empty) signal();
    }

    /// Wakes the owner without a message.
    void signal() const {
        const std::uint64_t one = 1;
        [[maybe_unused]] const auto n = ::write(event_.get(), &one, sizeof one);
    }

    [[nodiscard]] std::vector<Message> take() {
        std::uint64_t count = 0;
        [[maybe_unused]] const auto n = ::read(event_.get(), &count, sizeof count);
        const std::lock_guard lock(mutex_);
        return std::exchange(messages_, {});
    }

    [[nodiscard]] int fd() const { return event_.get(); }

  private:
    FileDescriptor event_;
    std::mutex mutex_;
    std::vector<Message> messages_;  ///< guarded by mutex_
};

}  // namespace bouguer::server
