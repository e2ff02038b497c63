// SPDX-License-Identifier: Apache-2.0
#include "server/http/handler_pool.h"

namespace bouguer::server {

HandlerPool::HandlerPool(int threads, std::size_t capacity, Work work)
    : capacity_(capacity), work_(std::move(work)) {
    for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { run(); });
}

HandlerPool::~HandlerPool() { stop(); }

bool HandlerPool::try_submit(std::unique_ptr<Exchange>& exchange) {
    {
        const std::lock_guard lock(mutex_);
        if (stopping_ || queue_.size() >= capacity_) return false;
        queue_.push_back(std::move(exchange));
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

void HandlerPool::run() {
    for (;;) {
        std::unique_lock lock(mutex_);
        some_.wait(lock, [this] { return stopping_ || !queue_.empty(); });
        if (stopping_) return;
        auto exchange = std::move(queue_.front());
        queue_.pop_front();
        lock.unlock();
        work_(std::move(exchange));
    }
}

}  // namespace bouguer::server
