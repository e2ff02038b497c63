// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/worker_pool.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <optional>

namespace bouguer::server {
namespace {

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
    : scheduler_(scheduler), num_threads_(std::max(1, threads)) {
    for (int i = 0; i < num_threads_; ++i) threads_.emplace_back([this] { work(); });
}

WorkerPool::~WorkerPool() { stop(); }

void WorkerPool::wake() {
    const std::lock_guard lock(mutex_);
    ++wakes_;
    if (idle_ > 0) news_.notify_all();
}

void WorkerPool::stop() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
        news_.notify_all();
    }
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

void WorkerPool::run(Scheduler::Work& work) {
    const auto begin = std::chrono::steady_clock::now();
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
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    scheduler_.charge(*work.task, spent.count());
}

void WorkerPool::work() {
    while (true) {
        std::uint64_t seen = 0;
        {
            const std::lock_guard lock(mutex_);
            if (stopping_) return;
            seen = wakes_;
        }
        if (std::optional<Scheduler::Work> work = scheduler_.next()) {
            run(*work);
            // The step may have ended a pass or a job: others can find work now.
            wake();
        } else if (!wait_for_news(seen)) {
            return;
        }
    }
}

}  // namespace bouguer::server
