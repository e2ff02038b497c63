// SPDX-License-Identifier: Apache-2.0
#include "server/http/handler_pool.h"

#include <chrono>
#include <new>

namespace bouguer::server {
namespace {

constexpr std::chrono::milliseconds kMemoryPause{50};

}  // namespace

HandlerPool::HandlerPool(const WorkQueue::Limits& limits, Work work)
    : work_(std::move(work)), queue_(limits) {
    for (int i = 0; i < limits.threads; ++i) threads_.emplace_back([this] { run(); });
}

HandlerPool::~HandlerPool() { stop(); }

bool HandlerPool::try_submit(std::unique_ptr<Exchange>& exchange) {
    {
        const std::lock_guard lock(mutex_);
        if (stopping_ || !queue_.push(exchange)) return false;
    }
    some_.notify_one();
    return true;
}

void HandlerPool::stop() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    some_.notify_all();
    for (std::thread& thread : threads_) {
        if (thread.joinable()) thread.join();
    }
}

WorkQueue::Work HandlerPool::wait_for_work() {
    WorkQueue::Work work;
    std::unique_lock lock(mutex_);
    while (!stopping_) {
        try {
            work = queue_.begin();
            if (work.exchange) break;
            some_.wait(lock);
        } catch (const std::bad_alloc&) {
            some_.wait_for(lock, kMemoryPause);  // nothing was taken
        }
    }
    return work;
}

void HandlerPool::run() {
    for (;;) {
        WorkQueue::Work work = wait_for_work();
        if (!work.exchange) return;
        work_(std::move(work.exchange));
        {
            const std::lock_guard lock(mutex_);
            queue_.end(work);
        }
        // what was held back because of this one may be begun by a thread that sleeps
        some_.notify_one();
    }
}

}  // namespace bouguer::server
