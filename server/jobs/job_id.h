// SPDX-License-Identifier: Apache-2.0
// Ids of jobs: UUID version 7.
#pragma once

#include <cstdint>
#include <mutex>
#include <random>
#include <string_view>

#include "server/jobs/job.h"

namespace bouguer::server {

/// Whether `text` is a lower-case UUID in its 36-character form.
[[nodiscard]] bool is_job_id(std::string_view text);

/// Makes ids that sort by time of making, also within one millisecond and when the clock is set
/// back [RFC 9562 §6.2, method 1: a counter in rand_a]. Thread-safe.
class JobIdMaker {
  public:
    [[nodiscard]] JobId make(std::int64_t now_ms);

  private:
    std::mutex mutex_;
    std::random_device random_;  // guarded by mutex_, as all below
    std::int64_t last_ms_ = 0;
    std::uint32_t counter_ = 0;  // 12 bits
};

}  // namespace bouguer::server
