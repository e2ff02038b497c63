// SPDX-License-Identifier: Apache-2.0
// How long a worker goes on with one piece of work.
#pragma once

#include <atomic>
#include <chrono>

namespace bouguer::renderer {

/// When tracing leaves off before a unit is complete. The unit goes on later where it was, on any
/// thread, and has the same bits as if it had never been left.
struct TraceLimits {
    using Clock = std::chrono::steady_clock;
    /// Looked at between samples; at least one is traced.
    Clock::time_point pause_at = Clock::time_point::max();
    /// Within samples too: what there is of the sample under way is thrown away.
    Clock::time_point give_up_at = Clock::time_point::max();
    const std::atomic<bool>* give_up = nullptr;  ///< likewise, when it becomes true; may be null
};

}  // namespace bouguer::renderer
