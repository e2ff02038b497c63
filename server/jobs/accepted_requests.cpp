// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/accepted_requests.h"

#include <algorithm>
#include <utility>

namespace bouguer::server {

void AcceptedRequests::keep(const JobId& id, api::JobRequest request, std::uint64_t bytes) {
    if (bytes > max_bytes_) return;
    request.canonical = {};
    std::list<Entry> dropped;  // destroyed without the lock: a scene can be large
    std::list<Entry> kept;
    kept.push_back({id, bytes, std::move(request)});
    const std::lock_guard lock(mutex_);
    entries_.splice(entries_.end(), kept);
    total_bytes_ += bytes;
    while (total_bytes_ > max_bytes_) {
        total_bytes_ -= entries_.front().bytes;
        dropped.splice(dropped.end(), entries_, entries_.begin());
    }
}

std::optional<api::JobRequest> AcceptedRequests::take(const JobId& id) {
    std::list<Entry> taken;
    {
        const std::lock_guard lock(mutex_);
        const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                        [&](const Entry& one) { return one.id == id; });
        if (entry == entries_.end()) return std::nullopt;
        total_bytes_ -= entry->bytes;
        taken.splice(taken.end(), entries_, entry);
    }
    return std::move(taken.front().request);
}

}  // namespace bouguer::server
