// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/worker_pool.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <optional>

namespace bouguer::server {
namespace {

constexpr std::chrono::milliseconds kMemoryPause{50};

/// Does not throw, not even when there is no memory for the text.
std::string internal_error(const char* what) noexcept {
    try {
        return std::string("internal error: ") + what;
    } catch (...) {
        return "out of memory";  // short enough to need none
    }
}

}  // namespace

WorkerPool::WorkerPool(Scheduler& scheduler, int threads)
    : scheduler_(scheduler), num_places_(std::max(1, threads)), free_places_(num_places_) {
    const int workers = num_places_ * kWorkersPerPlace;
    running_.reserve(static_cast<std::size_t>(workers));
    for (int i = 0; i < workers; ++i) threads_.emplace_back([this] { work(); });
}

WorkerPool::~WorkerPool() { stop(); }

void WorkerPool::wake() {
    const std::lock_guard lock(mutex_);
    ++wakes_;
    if (idle_ > 0) news_.notify_all();
}

void WorkerPool::refuse_new() {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    news_.notify_all();
    places_.notify_all();
}

void WorkerPool::stop() {
    refuse_new();
    for (std::thread& thread : threads_) {
        if (thread.joinable()) thread.join();
    }
}

bool WorkerPool::wait_for_news(std::uint64_t seen) {
    std::unique_lock lock(mutex_);
    ++idle_;
    news_.wait(lock, [&] { return stopping_ || wakes_ != seen; });
    --idle_;
    return !stopping_;
}

bool WorkerPool::take_place() {
    std::unique_lock lock(mutex_);
    while (!stopping_ && free_places_ == 0) {
        if (is_watched_) {
            places_.wait(lock);
        } else {
            watch_steps(lock);
        }
    }
    if (stopping_) return false;
    --free_places_;
    places_.notify_all();  // somebody else is to watch
    return true;
}

/// Waits until a step may have become long and takes the places of those that have.
void WorkerPool::watch_steps(std::unique_lock<std::mutex>& lock) {
    is_watched_ = true;
    // A step that begins meanwhile becomes long later than this.
    Clock::time_point due = Clock::now() + kLongStep;
    for (const Running* step : running_) {
        if (step->has_place) due = std::min(due, step->began + kLongStep);
    }
    places_.wait_until(lock, due);
    is_watched_ = false;
    const auto now = Clock::now();
    for (Running* step : running_) {
        if (!step->has_place || now - step->began < kLongStep) continue;
        step->has_place = false;
        ++free_places_;
    }
}

void WorkerPool::run_step(Scheduler::Work& work) {
    try {
        work.run();
    } catch (const std::bad_alloc&) {
        work.task->fail("out of memory");
    } catch (const std::exception& e) {
        work.task->fail(internal_error(e.what()));
    } catch (...) {
        work.task->fail("internal error");
    }
    work.run = nullptr;
}

bool WorkerPool::run(Scheduler::Work& work) {
    Running running{Clock::now()};
    {
        const std::lock_guard lock(mutex_);
        running_.push_back(&running);
    }
    run_step(work);
    const std::chrono::duration<double> spent = Clock::now() - running.began;
    scheduler_.charge(*work.task, spent.count());
    const std::lock_guard lock(mutex_);
    std::erase(running_, &running);
    return running.has_place;
}

/// Out of memory it waits until there is some again: no step was taken then.
std::optional<Scheduler::Work> WorkerPool::next_step() {
    while (true) {
        try {
            return scheduler_.next(num_places_);
        } catch (const std::bad_alloc&) {
            const std::lock_guard lock(mutex_);
            if (stopping_) return std::nullopt;
        }
        std::this_thread::sleep_for(kMemoryPause);
    }
}

void WorkerPool::work() {
    while (take_place()) work_in_place();
}

void WorkerPool::work_in_place() {
    while (true) {
        std::uint64_t seen = 0;
        {
            const std::lock_guard lock(mutex_);
            if (stopping_) return;
            seen = wakes_;
        }
        if (std::optional<Scheduler::Work> work = next_step()) {
            const bool has_place = run(*work);
            // The step may have ended a pass or a job: others can find work now.
            wake();
            if (!has_place) return;
        } else if (!wait_for_news(seen)) {
            return;
        }
    }
}

}  // namespace bouguer::server
