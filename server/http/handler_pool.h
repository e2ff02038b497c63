// SPDX-License-Identifier: Apache-2.0
// The few threads on which requests are handled. They work from memory to memory and never wait for
// a client.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "server/http/work_queue.h"

namespace bouguer::server {

class HandlerPool {
  public:
    using Work = std::function<void(std::unique_ptr<Exchange>)>;

    /// `work` must not throw. `limits.threads` threads are started.
    HandlerPool(const WorkQueue::Limits& limits, Work work);
    ~HandlerPool();  ///< stop()
    HandlerPool(const HandlerPool&) = delete;
    HandlerPool& operator=(const HandlerPool&) = delete;

    /// False, and `exchange` stays with the caller, when as many as are allowed wait.
    [[nodiscard]] bool try_submit(std::unique_ptr<Exchange>& exchange);

    /// Finishes what is being worked on, drops what waits, joins. Idempotent.
    void stop();

  private:
    void run();
    /// The next that may be begun; without an exchange when the pool stops.
    [[nodiscard]] WorkQueue::Work wait_for_work();

    const Work work_;
    std::mutex mutex_;
    std::condition_variable some_;
    WorkQueue queue_;        ///< guarded by mutex_
    bool stopping_ = false;  ///< guarded by mutex_
    std::vector<std::thread> threads_;
};

}  // namespace bouguer::server
