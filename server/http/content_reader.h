// SPDX-License-Identifier: Apache-2.0
// The thread that waits for the disk while answers go out, so that the front never does.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "server/content.h"

namespace bouguer::server {

/// Reads in the order in which it is asked. Thread-safe.
class ContentReader {
  public:
    struct Request {
        std::uint64_t connection = 0;  ///< for whom
        Content content;               ///< all of it is read
        std::string room;              ///< memory to use
    };
    /// Gets the bytes, or why there are none; on the reader's thread. Must not throw.
    using Deliver = std::function<void(std::uint64_t connection, Result<std::string> bytes)>;

    explicit ContentReader(Deliver deliver);
    ~ContentReader();  ///< stop()
    ContentReader(const ContentReader&) = delete;
    ContentReader& operator=(const ContentReader&) = delete;

    void ask(Request request);
    /// Drops what waits, joins. Idempotent.
    void stop();

  private:
    void run();

    const Deliver deliver_;
    std::mutex mutex_;
    std::condition_variable some_;
    std::deque<Request> queue_;  ///< guarded by mutex_
    bool stopping_ = false;      ///< guarded by mutex_
    std::thread thread_;
};

}  // namespace bouguer::server
