// SPDX-License-Identifier: Apache-2.0
// Which step of which job comes next.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <vector>

#include "renderer/core/result.h"
#include "server/jobs/task.h"

namespace bouguer::server {

struct SchedulerLimits {
    std::size_t tasks = 1000;                  ///< waiting and active together
    std::size_t active_tasks = 64;             ///< that have begun and have not ended
    std::uint64_t memory_bytes = 4ULL << 30U;  ///< of all active tasks together, as they estimate
};

/// A bounded queue and a rule. A task waits until it is activated, which takes its share of the
/// memory; the first in the queue is activated as soon as it fits, or when nothing else is active.
/// Tasks that run alone stand before all others. Of all that could run, the next step is that of
/// the most urgent (a first pass before all later ones, so that everybody sees something soon),
/// then of the highest priority. Equals share: later passes go by the time that their tasks have
/// had, the least first, and a newcomer's time starts at that of the task that has had least; first
/// passes go by age, but in turns of kTurn_s. A first pass that has had kHeadStart_s is long: it
/// has had its chance, and from then on shares with the later passes as one of them, so that nobody
/// waits for the end of it. All times are seconds of threads, not of the clock. Thread-safe.
class Scheduler {
  public:
    explicit Scheduler(SchedulerLimits limits = {}) : limits_(limits) {}

    /// Puts a task into the queue. Busy when it is full.
    [[nodiscard]] Result<void> add(std::shared_ptr<Task> task);
    /// Likewise without regard to the bound: jobs that were accepted before a restart.
    void add_again(std::shared_ptr<Task> task);
    /// Takes a task out of the queue if it has not been activated.
    void drop(const Task& task);
    [[nodiscard]] bool full() const;
    /// Whether tasks of the queue are activated. What is active goes on either way.
    void hold(bool is_held);

    struct Work {
        std::shared_ptr<Task> task;
        Task::Step run;
    };
    /// The next step; empty when there is none now. Ended tasks are let go of. Gives none of a task
    /// that has `most_steps` under way.
    [[nodiscard]] std::optional<Work> next(int most_steps = std::numeric_limits<int>::max());
    /// Tells that a step has ended and how long it took, for the sharing among equals.
    void charge(const Task& task, double seconds);

    /// A first pass gives way to others of its kind after so much time ...
    static constexpr double kTurn_s = 0.25;
    /// ... and to all passes after so much.
    static constexpr double kHeadStart_s = 1;

    [[nodiscard]] std::size_t num_waiting() const;
    [[nodiscard]] std::size_t num_active() const;

  private:
    struct Entry {
        std::shared_ptr<Task> task;
        std::uint64_t sequence = 0;  ///< age
        double time = 0;             ///< seconds of threads, from the newcomer's start
        double spent = 0;            ///< likewise, of its own
        int steps_under_way = 0;
        Urgency urgency = Urgency::FirstPass;  ///< as it was when next() looked: it may change
    };
    struct QueueOrder {
        bool operator()(const Entry& a, const Entry& b) const;
    };
    /// What it is to the others, whatever it says itself.
    [[nodiscard]] static Urgency urgency_of(const Entry& entry);
    static bool goes_before(const Entry& a, const Entry& b);

    void enqueue(std::shared_ptr<Task> task);
    void let_go_of_ended();
    [[nodiscard]] bool fits(const Task& task) const;
    void activate_what_fits();

    const SchedulerLimits limits_;
    mutable std::mutex mutex_;
    std::uint64_t sequence_ = 0;  // guarded by mutex_, as all below
    std::set<Entry, QueueOrder> waiting_;
    std::vector<Entry> active_;
    std::uint64_t memory_in_use_ = 0;  // of active_
    bool is_held_ = false;
};

}  // namespace bouguer::server
