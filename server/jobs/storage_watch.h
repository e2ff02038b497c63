// SPDX-License-Identifier: Apache-2.0
// Whether what comes can be stored: known at any time without waiting for a disk.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "renderer/core/result.h"

namespace bouguer::server {

struct StorageWatchTimes {
    std::chrono::milliseconds between_probes{1'000};  ///< that go well
    std::chrono::milliseconds first_retry{50};        ///< after a failure; doubles with every one
    std::chrono::milliseconds longest_retry{2'000};
    std::chrono::milliseconds longest_probe{10'000};  ///< then the storage counts as failed
};

/// A thread that probes the storage and, when it works, has done what is left to do. A failure that
/// anybody reports counts at once, and until kGoodLooks later probes in a row, and all that is
/// left, have gone well: of a disk that fails now and then one good write says little. Thread-safe.
class StorageWatch {
  public:
    static constexpr int kGoodLooks = 3;
    using Work = std::function<Result<void>()>;  ///< called by the watch's thread

    /// `probe` writes something; `catch_up` does what waits for the storage. Nothing runs before
    /// start().
    StorageWatch(Work probe, Work catch_up, StorageWatchTimes times = {});
    /// As stop().
    ~StorageWatch();
    StorageWatch(const StorageWatch&) = delete;
    StorageWatch& operator=(const StorageWatch&) = delete;

    void start();
    /// Waits for a probe under way. Idempotent.
    void stop();

    /// Something could not be stored.
    void report(const Error& error);
    /// The newest error that holds, or that a probe hangs; nothing when all is well.
    [[nodiscard]] std::optional<Error> error() const;

  private:
    using Clock = std::chrono::steady_clock;

    void run();
    /// Sleeps until the next probe is due; false when the watch stops.
    [[nodiscard]] bool wait();
    [[nodiscard]] Result<void> look();
    void note_probing(std::optional<Clock::time_point> since);
    void settle(const Result<void>& result, std::uint64_t reports_before);

    const Work probe_, catch_up_;
    const StorageWatchTimes times_;
    mutable std::mutex mutex_;
    std::condition_variable news_;
    std::optional<Error> error_;                      // guarded by mutex_, as all below
    std::uint64_t reports_ = 0;                       ///< calls of report()
    int good_looks_ = 0;                              ///< in a row, since the last report
    std::chrono::milliseconds retry_{0};              ///< the next wait after a failure
    std::optional<Clock::time_point> probing_since_;  ///< empty: no probe is under way
    bool stopping_ = false;
    std::thread thread_;  // last: it uses all the others; used by start() and stop() only
};

}  // namespace bouguer::server
