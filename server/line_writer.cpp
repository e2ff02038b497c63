// SPDX-License-Identifier: Apache-2.0
#include "server/line_writer.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <condition_variable>
#include <mutex>
#include <new>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace bouguer::server {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kLook_ms = 50;  // how soon a wait for the reader notices the end
constexpr std::size_t kLineOverhead = sizeof(std::string);
constexpr std::chrono::milliseconds kLastStep{100};  // for a thread that was told to end

}  // namespace

struct LineWriter::State {
    std::mutex mutex;
    std::condition_variable changed;  ///< lines, the end, or that the thread has ended

    // guarded by mutex
    std::vector<std::string> lines;
    std::size_t bytes = 0;      ///< of `lines` and of those that are being written
    std::uint64_t dropped = 0;  ///< behind `lines`
    std::optional<Clock::time_point> last_moment;  ///< of writing; set by the end
    bool has_ended = false;
};

/// What runs on the thread.
class LineWriter::Work {
  public:
    Work(std::shared_ptr<State> state, int fd, DropNote note)
        : state_(std::move(state)), fd_(fd), note_(std::move(note)) {}

    void run() {
        while (take()) {
            for (const std::string& line : lines_) {
                if (!write(line)) ++dropped_;
            }
            // what cannot be told now is told behind the next lines
            if (dropped_ > 0 && tell_dropped()) dropped_ = 0;
            lines_.clear();
        }
    }

  private:
    /// Waits for something to write. False: it is the end.
    bool take() {
        std::unique_lock lock(state_->mutex);
        state_->bytes -= taken_bytes_;
        state_->changed.wait(lock, [this] {
            return !state_->lines.empty() || state_->dropped > 0 || state_->last_moment;
        });
        const bool is_end = state_->lines.empty() && state_->dropped == 0;
        std::swap(lines_, state_->lines);
        taken_bytes_ = state_->bytes;
        dropped_ += std::exchange(state_->dropped, 0);
        return !is_end;
    }

    bool tell_dropped() {
        try {
            return write(note_(dropped_));
        } catch (const std::bad_alloc&) {
            return false;
        }
    }

    bool is_too_late() {
        const std::lock_guard lock(state_->mutex);
        return state_->last_moment && Clock::now() >= *state_->last_moment;
    }

    /// Waits until the descriptor takes something or has an error to tell. False: it is too late.
    bool wait_for_room() {
        while (!is_too_late()) {
            pollfd room{fd_, POLLOUT, 0};
            const int n = ::poll(&room, 1, kLook_ms);
            if (n > 0 || (n < 0 && errno != EINTR)) return true;
        }
        return false;
    }

    /// False: not all of it could be written.
    bool write(std::string_view line) {
        if (is_torn_ && !write_all("\n")) return false;
        is_torn_ = false;
        return write_all(line);
    }

    bool write_all(std::string_view text) {
        const std::size_t size = text.size();
        while (!text.empty()) {
            if (!wait_for_room()) return false;
            const auto n = ::write(fd_, text.data(), std::min<std::size_t>(text.size(), PIPE_BUF));
            if (n < 0 && (errno == EINTR || errno == EAGAIN || errno == EWOULDBLOCK)) continue;
            if (n <= 0) {
                is_torn_ = is_torn_ || text.size() < size;
                return false;
            }
            text.remove_prefix(static_cast<std::size_t>(n));
        }
        return true;
    }

    const std::shared_ptr<State> state_;
    const int fd_;
    const DropNote note_;
    std::vector<std::string> lines_;
    std::size_t taken_bytes_ = 0;  ///< of `lines_`
    std::uint64_t dropped_ = 0;    ///< that nobody has been told of
    bool is_torn_ = false;         ///< the last line was written in part
};

LineWriter::LineWriter(int fd, DropNote note, LineWriterOptions options)
    : options_(options), state_(std::make_shared<State>()) {
    thread_ = std::thread([state = state_, fd, note = std::move(note)]() mutable {
        Work(state, fd, std::move(note)).run();
        const std::lock_guard lock(state->mutex);
        state->has_ended = true;
        state->changed.notify_all();
    });
}

LineWriter::~LineWriter() {
    std::unique_lock lock(state_->mutex);
    state_->last_moment = Clock::now() + options_.patience;
    state_->changed.notify_all();
    const bool has_ended = state_->changed.wait_until(lock, *state_->last_moment + kLastStep,
                                                      [this] { return state_->has_ended; });
    lock.unlock();
    has_ended ? thread_.join() : thread_.detach();
}

void LineWriter::add(std::string line) {
    const std::lock_guard lock(state_->mutex);
    const std::size_t bytes = line.size() + kLineOverhead;
    // Behind a line that was dropped come only dropped ones until that is told: the order holds.
    if (state_->dropped > 0 || state_->bytes + bytes > options_.bytes) {
        ++state_->dropped;
    } else {
        state_->bytes += bytes;
        state_->lines.push_back(std::move(line));
    }
    state_->changed.notify_one();
}

}  // namespace bouguer::server
