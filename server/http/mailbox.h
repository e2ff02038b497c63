// SPDX-License-Identifier: Apache-2.0
// Messages to a thread that sleeps in epoll.
#pragma once

#include <sys/eventfd.h>

#include <chrono>
#include <cstdint>
#include <mutex>
#include <new>
#include <thread>
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

    /// For what must arrive: out of memory it waits until there is some again.
    void post_surely(Message message) noexcept {
        for (;;) {
            try {
                const std::lock_guard lock(mutex_);
                messages_.emplace_back();
                messages_.back() = std::move(message);
                break;
            } catch (const std::bad_alloc&) {
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
            }
        }
        signal();
    }

    /// For a hint that the owner can do without: out of memory it is lost.
    void try_post(Message message) noexcept {
        try {
            post(std::move(message));
        } catch (const std::bad_alloc&) {
            signal();
        }
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
