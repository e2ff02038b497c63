// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/unstored_ends.h"

namespace bouguer::server {

void UnstoredEnds::add(const JobId& id, Outcome outcome) {
    const std::lock_guard lock(mutex_);
    outcomes_[id] = std::move(outcome);
}

void UnstoredEnds::erase(const JobId& id) {
    const std::lock_guard lock(mutex_);
    outcomes_.erase(id);
}

std::vector<JobId> UnstoredEnds::ids() const {
    const std::lock_guard lock(mutex_);
    std::vector<JobId> ids;
    for (const auto& [id, outcome] : outcomes_) ids.push_back(id);
    return ids;
}

UnstoredEnds::Outcome UnstoredEnds::find(const JobId& id) const {
    const std::lock_guard lock(mutex_);
    const auto it = outcomes_.find(id);
    return it == outcomes_.end() ? nullptr : it->second;
}

}  // namespace bouguer::server
