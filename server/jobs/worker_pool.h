// SPDX-License-Identifier: Apache-2.0
// The threads that render.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "server/jobs/scheduler.h"

namespace bouguer::server {

/// Runs the scheduler's steps on `threads` threads. This is the job boundary: whatever a step
/// throws fails its task and nothing else; the worker lives on.
class WorkerPool {
  public:
    /// `scheduler` outlives the pool. At least one thread.
    WorkerPool(Scheduler& scheduler, int threads);
    /// As stop().
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    /// Says that there may be new steps. Thread-safe.
    void wake();
    /// Lets the steps under way come to their end, begins no other and joins the threads. Not from
    /// a worker.
    void stop();
    [[nodiscard]] int num_threads() const { return num_threads_; }

  private:
    void work();
    void run(Scheduler::Work& work);
    /// Waits for a wake() after `seen`; false when the pool stops.
    [[nodiscard]] bool wait_for_news(std::uint64_t seen);

    Scheduler& scheduler_;
    std::mutex mutex_;
    std::condition_variable news_;
    std::uint64_t wakes_ = 0;  // guarded by mutex_, as all below
    int idle_ = 0;
    bool stopping_ = false;
    int num_threads_;
    std::vector<std::thread> threads_;  // last: they use all the others
};

}  // namespace bouguer::server
