// SPDX-License-Identifier: Apache-2.0
// The threads that render.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "server/jobs/scheduler.h"

namespace bouguer::server {

/// Runs the scheduler's steps on `threads` threads. This is the job boundary: whatever a step
/// throws fails its task and nothing else; the worker lives on.
///
/// There are as many places as threads were asked for, and a worker needs one to begin a step. Most
/// steps are short, but some cannot be left in the middle (a scene is built, a large picture
/// encoded, one sample follows thousands of rays): a step that lasts longer than kLongStep loses
/// its place to a spare worker, which serves other tasks meanwhile, and its own worker waits for a
/// place when it comes back. Of one task there are never more steps under way than places, so that
/// the spares are there for others.
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
    /// Begins no other step. Thread-safe.
    void refuse_new();
    /// As refuse_new(); lets the steps under way come to their end and joins the threads. Not from
    /// a worker.
    void stop();
    [[nodiscard]] int num_threads() const { return num_places_; }

    /// Steps of this length no longer hold a place.
    static constexpr std::chrono::milliseconds kLongStep{250};
    /// Workers for every place, one of them spare at first. They bound how many long steps there
    /// may be beside the ordinary ones.
    static constexpr int kWorkersPerPlace = 3;

  private:
    using Clock = std::chrono::steady_clock;

    /// A step under way.
    struct Running {
        Clock::time_point began;
        bool has_place = true;  ///< guarded by mutex_
    };

    void work();
    void work_in_place();
    [[nodiscard]] std::optional<Scheduler::Work> next_step();
    /// Runs a step. False: it took so long that its place is another's now.
    [[nodiscard]] bool run(Scheduler::Work& work);
    void run_step(Scheduler::Work& work);
    /// Waits for a wake() after `seen`; false when the pool stops.
    [[nodiscard]] bool wait_for_news(std::uint64_t seen);
    /// Waits for a place, if need be for that of a long step; false when the pool stops.
    [[nodiscard]] bool take_place();
    void watch_steps(std::unique_lock<std::mutex>& lock);

    Scheduler& scheduler_;
    const int num_places_;
    std::mutex mutex_;
    std::condition_variable news_, places_;
    std::uint64_t wakes_ = 0;  // guarded by mutex_, as all below
    int idle_ = 0;
    bool stopping_ = false;
    int free_places_;
    bool is_watched_ = false;  ///< one of those who wait for a place looks after the steps
    std::vector<Running*> running_;
    std::vector<std::thread> threads_;  // last: they use all the others
};

}  // namespace bouguer::server
