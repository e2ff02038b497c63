// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/storage_watch.h"

#include <algorithm>

#include "server/log.h"

namespace bouguer::server {

StorageWatch::StorageWatch(Work probe, Work catch_up, StorageWatchTimes times)
    : probe_(std::move(probe)),
      catch_up_(std::move(catch_up)),
      times_(times),
      retry_(times.first_retry) {}

StorageWatch::~StorageWatch() { stop(); }

void StorageWatch::start() {
    thread_ = std::thread([this] { run(); });
}

void StorageWatch::stop() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
        news_.notify_all();
    }
    if (thread_.joinable()) thread_.join();
}

void StorageWatch::report(const Error& error) {
    const std::lock_guard lock(mutex_);
    ++reports_;
    good_looks_ = 0;
    if (!error_) {
        log_event(LogLevel::Error, "storage-fault",
                  {{"code", error.code}, {"error", error.message}});
        retry_ = times_.first_retry;
    }
    error_ = error;
    news_.notify_all();
}

std::optional<Error> StorageWatch::error() const {
    const std::lock_guard lock(mutex_);
    if (error_ || !probing_since_ || Clock::now() - *probing_since_ < times_.longest_probe) {
        return error_;
    }
    return Error{ErrorKind::Internal, "the storage does not answer", {}, "storage-failed"};
}

void StorageWatch::note_probing(std::optional<Clock::time_point> since) {
    const std::lock_guard lock(mutex_);
    probing_since_ = since;
}

bool StorageWatch::wait() {
    std::unique_lock lock(mutex_);
    const bool was_good = !error_ || good_looks_ > 0;
    if (was_good) {
        // a failure that is reported meanwhile ends the wait
        news_.wait_for(lock, times_.between_probes,
                       [&] { return stopping_ || (error_ && good_looks_ == 0); });
    }
    if (error_ && good_looks_ == 0 && !stopping_) {
        news_.wait_for(lock, retry_, [&] { return stopping_; });
        retry_ = std::min(retry_ * 2, times_.longest_retry);
    }
    return !stopping_;
}

Result<void> StorageWatch::look() {
    try {
        note_probing(Clock::now());
        auto probed = probe_();
        note_probing({});
        return probed ? catch_up_() : probed;
    } catch (const std::exception& e) {  // memory
        note_probing({});
        return fail(ErrorKind::Internal, e.what(), "storage-failed");
    }
}

void StorageWatch::settle(const Result<void>& result, std::uint64_t reports_before) {
    if (!result) return report(result.error());
    const std::lock_guard lock(mutex_);
    // What was reported meanwhile may have come after the probe.
    if (reports_ != reports_before || !error_ || ++good_looks_ < kGoodLooks) return;
    log_event(LogLevel::Warning, "storage-well-again", {});
    error_.reset();
}

void StorageWatch::run() {
    while (wait()) {
        std::uint64_t reports_before = 0;
        {
            const std::lock_guard lock(mutex_);
            reports_before = reports_;
        }
        try {
            settle(look(), reports_before);
        } catch (const std::exception&) {
            // no memory to keep an error: the next look will do
        }
    }
}

}  // namespace bouguer::server
