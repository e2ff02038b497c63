// SPDX-License-Identifier: Apache-2.0
// What the scheduler and the workers know of a job: an order and steps. Nothing of renderers.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "server/jobs/job.h"

namespace bouguer::server {

/// What the next step of a task is good for; smaller goes first.
enum class Urgency {
    Finish,     ///< all is computed: write it down, give the memory back
    FirstPass,  ///< nobody has seen anything of this job yet
    LaterPass   ///< there is a picture; it gets better
};

/// One job as work in small steps. Thread-safe.
class Task {
  public:
    using Step = std::function<void()>;  ///< runs once, on any thread; may throw

    virtual ~Task() = default;

    [[nodiscard]] virtual const JobId& id() const = 0;
    [[nodiscard]] virtual int priority() const = 0;  ///< higher goes first
    /// What it is expected to hold from its first step to its end.
    [[nodiscard]] virtual std::uint64_t memory_bytes() const = 0;

    /// Whether nothing else may be active beside it.
    [[nodiscard]] virtual bool runs_alone() const { return false; }

    [[nodiscard]] virtual Urgency urgency() const = 0;
    /// Takes a step; empty when there is none to hand out now. What is taken must be run.
    [[nodiscard]] virtual std::optional<Step> next_step() = 0;
    /// No step is under way and none will come.
    [[nodiscard]] virtual bool ended() const = 0;
    /// A step threw. The task ends as soon as its other steps have.
    virtual void fail(std::string reason) noexcept = 0;
};

}  // namespace bouguer::server
