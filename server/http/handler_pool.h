// SPDX-License-Identifier: Apache-2.0
// The threads that run the routes. They work on complete requests in memory and never wait for a
// client.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "server/http/exchange.h"

namespace bouguer::server {

class HandlerPool {
  public:
    using Work = std::function<void(std::unique_ptr<Exchange>)>;

    /// `work` must not throw. At most `capacity` exchanges wait.
    HandlerPool(int threads, std::size_t capacity, Work work);
    ~HandlerPool();  ///< stop()
    HandlerPool(const HandlerPool&) = delete;
    HandlerPool& operator=(const HandlerPool&) = delete;

    /// False, and `exchange` stays with the caller, when the queue is full.
    [[nodiscard]] bool try_submit(std::unique_ptr<Exchange>& exchange);

    /// Finishes what is being worked on, drops what waits, joins. Idempotent.
    void stop();

  private:
    void run();

    const std::size_t capacity_;
    const Work work_;
    std::mutex mutex_;
    std::condition_variable some_;
    std::deque<std::unique_ptr<Exchange>> queue_;  ///< guarded by mutex_
    bool stopping_ = false;                        ///< guarded by mutex_
    std::vector<std::thread> threads_;
};

}  // namespace bouguer::server
