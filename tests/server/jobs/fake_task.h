// SPDX-License-Identifier: Apache-2.0
// A task of counted steps, without a renderer.
#pragma once

#include <atomic>
#include <mutex>
#include <new>
#include <string>
#include <utility>

#include "server/jobs/task.h"

namespace bouguer::server {

/// Has `first` steps of a first pass and `later` steps of later ones; each calls `on_step`.
class FakeTask final : public Task {
  public:
    FakeTask(JobId id, int priority, int first, int later, std::uint64_t memory = 1,
             std::function<void()> on_step = {})
        : id_(std::move(id)),
          priority_(priority),
          first_(first),
          later_(later),
          memory_(memory),
          on_step_(std::move(on_step)) {}

    const JobId& id() const override { return id_; }
    int priority() const override { return priority_; }
    std::uint64_t memory_bytes() const override { return memory_; }
    Urgency urgency() const override {
        const std::lock_guard lock(mutex_);
        return first_ > 0 ? Urgency::FirstPass : Urgency::LaterPass;
    }
    std::optional<Step> next_step() override {
        const std::lock_guard lock(mutex_);
        if (shortages > 0) {
            --shortages;
            throw std::bad_alloc();
        }
        if (!failure_.empty() || first_ + later_ == 0) return std::nullopt;
        --(first_ > 0 ? first_ : later_);
        ++under_way_;
        return [this] {
            const Done done{*this};
            if (on_step_) on_step_();
        };
    }
    bool ended() const override {
        const std::lock_guard lock(mutex_);
        return under_way_ == 0 && (first_ + later_ == 0 || !failure_.empty());
    }
    void fail(std::string reason) noexcept override {
        const std::lock_guard lock(mutex_);
        failure_ = std::move(reason);
    }

    int steps_done() const {
        const std::lock_guard lock(mutex_);
        return done_;
    }
    std::string failure() const {
        const std::lock_guard lock(mutex_);
        return failure_;
    }

    std::atomic<int> shortages = 0;  ///< so often there is no memory for a step

  private:
    struct Done {
        FakeTask& task;
        ~Done() {
            const std::lock_guard lock(task.mutex_);
            --task.under_way_;
            ++task.done_;
        }
    };

    const JobId id_;
    const int priority_;
    mutable std::mutex mutex_;
    int first_, later_;  // guarded by mutex_, as all below
    int under_way_ = 0;
    int done_ = 0;
    std::string failure_;
    const std::uint64_t memory_;
    const std::function<void()> on_step_;
};

}  // namespace bouguer::server
