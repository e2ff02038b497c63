// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/scheduler.h"

#include <algorithm>
#include <cmath>

namespace bouguer::server {

bool Scheduler::QueueOrder::operator()(const Entry& a, const Entry& b) const {
    if (a.task->runs_alone() != b.task->runs_alone()) return a.task->runs_alone();
    if (a.task->priority() != b.task->priority()) return a.task->priority() > b.task->priority();
    return a.sequence < b.sequence;
}

Urgency Scheduler::urgency_of(const Entry& entry) {
    const Urgency urgency = entry.task->urgency();
    const bool is_long = urgency == Urgency::FirstPass && entry.spent >= kHeadStart_s;
    return is_long ? Urgency::LaterPass : urgency;
}

bool Scheduler::goes_before(const Entry& a, const Entry& b) {
    if (a.urgency != b.urgency) return a.urgency < b.urgency;
    if (a.task->priority() != b.task->priority()) return a.task->priority() > b.task->priority();
    if (a.urgency == Urgency::LaterPass && a.time != b.time) return a.time < b.time;
    if (a.urgency == Urgency::FirstPass) {
        const double turns_a = std::floor(a.spent / kTurn_s);
        const double turns_b = std::floor(b.spent / kTurn_s);
        if (turns_a != turns_b) return turns_a < turns_b;
    }
    return a.sequence < b.sequence;
}

Result<void> Scheduler::add(std::shared_ptr<Task> task) {
    const std::lock_guard lock(mutex_);
    let_go_of_ended();
    if (waiting_.size() + active_.size() >= limits_.tasks) {
        return fail(ErrorKind::Busy, "the queue is full", "queue-full");
    }
    enqueue(std::move(task));
    return {};
}

void Scheduler::add_again(std::shared_ptr<Task> task) {
    const std::lock_guard lock(mutex_);
    enqueue(std::move(task));
}

void Scheduler::enqueue(std::shared_ptr<Task> task) {
    waiting_.insert({std::move(task), ++sequence_});
}

void Scheduler::drop(const Task& task) {
    const std::lock_guard lock(mutex_);
    std::erase_if(waiting_, [&](const Entry& entry) { return entry.task.get() == &task; });
}

bool Scheduler::full() const {
    const std::lock_guard lock(mutex_);
    return waiting_.size() + active_.size() >= limits_.tasks;
}

void Scheduler::hold(bool is_held) {
    const std::lock_guard lock(mutex_);
    is_held_ = is_held;
}

void Scheduler::let_go_of_ended() {
    std::erase_if(active_, [&](const Entry& entry) {
        if (!entry.task->ended()) return false;
        memory_in_use_ -= entry.task->memory_bytes();
        return true;
    });
}

bool Scheduler::fits(const Task& task) const {
    if (is_held_) return false;
    if (active_.empty()) return true;
    if (task.runs_alone() || active_.front().task->runs_alone()) return false;
    return active_.size() < limits_.active_tasks && memory_in_use_ <= limits_.memory_bytes &&
           task.memory_bytes() <= limits_.memory_bytes - memory_in_use_;
}

void Scheduler::activate_what_fits() {
    // Nobody overtakes the first in the queue: a large job would wait for ever behind small ones.
    while (!waiting_.empty() && fits(*waiting_.begin()->task)) {
        active_.reserve(active_.size() + 1);  // throws before the task is between the two
        Entry entry = std::move(waiting_.extract(waiting_.begin()).value());
        const auto least =
            std::min_element(active_.begin(), active_.end(),
                             [](const Entry& a, const Entry& b) { return a.time < b.time; });
        if (least != active_.end()) entry.time = least->time;
        memory_in_use_ += entry.task->memory_bytes();
        active_.push_back(std::move(entry));
    }
}

std::optional<Scheduler::Work> Scheduler::next(int most_steps) {
    const std::lock_guard lock(mutex_);
    let_go_of_ended();
    activate_what_fits();
    for (Entry& entry : active_) entry.urgency = urgency_of(entry);
    std::sort(active_.begin(), active_.end(), goes_before);
    for (Entry& entry : active_) {
        if (entry.steps_under_way >= most_steps) continue;
        auto step = entry.task->next_step();
        if (!step) continue;
        ++entry.steps_under_way;
        return Work{entry.task, std::move(*step)};
    }
    return std::nullopt;
}

void Scheduler::charge(const Task& task, double seconds) {
    const std::lock_guard lock(mutex_);
    const auto entry = std::find_if(active_.begin(), active_.end(),
                                    [&](const Entry& e) { return e.task.get() == &task; });
    if (entry == active_.end()) return;
    --entry->steps_under_way;
    entry->time += seconds;
    entry->spent += seconds;
}

std::size_t Scheduler::num_waiting() const {
    const std::lock_guard lock(mutex_);
    return waiting_.size();
}

std::size_t Scheduler::num_active() const {
    const std::lock_guard lock(mutex_);
    return active_.size();
}

}  // namespace bouguer::server
