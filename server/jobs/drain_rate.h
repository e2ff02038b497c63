// SPDX-License-Identifier: Apache-2.0
// How fast jobs come to an end, and so, when it is worth asking again.
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>

namespace bouguer::server {

/// Counts ends, and the time in which there was something to end, each with a weight that falls by
/// e within a minute of such time: their ratio is the rate of about the last minute of work,
/// however long ago that was. Thread-safe.
class DrainRate {
  public:
    using Clock = std::chrono::steady_clock;

    static constexpr int kLeast_s = 1, kMost_s = 120;
    /// Said until so many jobs have ended: fewer are no measure.
    static constexpr int kUnmeasured_s = 5, kFewestEnds = 3;

    /// A job has come.
    void begin(Clock::time_point now);
    /// A job has ended, in whatever way.
    void end(Clock::time_point now);

    /// When the jobs that are there now will have ended, going by what was measured. Seconds,
    /// rounded up, in [kLeast_s, kMost_s].
    ///
    /// Until there is a measure it is a constant: a guess from the time in which nothing has ended
    /// would send clients away for minutes from a service that has just begun.
    [[nodiscard]] int seconds_to_drain(Clock::time_point now) const;

  private:
    struct Measure {
        std::size_t jobs = 0;  ///< that have not ended
        int ends_seen = 0;     ///< up to kFewestEnds
        double ends = 0;       ///< weighted number
        double busy_s = 0;     ///< weighted time with jobs
        Clock::time_point at{};
    };
    /// `measure` as it is at `now`.
    static Measure brought_to(Clock::time_point now, Measure measure);

    mutable std::mutex mutex_;
    Measure measure_;  ///< guarded by mutex_
};

}  // namespace bouguer::server
