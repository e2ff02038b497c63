// SPDX-License-Identifier: Apache-2.0
// Ends of jobs that the storage has not taken yet.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "server/jobs/render_task.h"

namespace bouguer::server {

/// What was rendered and could not be stored: kept until it is, so that a fault of the disk costs
/// nothing that was finished. It is bounded by what was active when the fault began, because
/// nothing is begun during one. Thread-safe.
class UnstoredEnds {
  public:
    using Outcome = std::shared_ptr<const RenderOutcome>;

    void add(const JobId& id, Outcome outcome);
    void erase(const JobId& id);
    [[nodiscard]] std::vector<JobId> ids() const;       ///< oldest job first
    [[nodiscard]] Outcome find(const JobId& id) const;  ///< null: none

  private:
    mutable std::mutex mutex_;
    std::map<JobId, Outcome> outcomes_;  // guarded by mutex_
};

}  // namespace bouguer::server
