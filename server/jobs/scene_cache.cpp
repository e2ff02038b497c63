// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/scene_cache.h"

#include <algorithm>

#include "api/digest.h"

namespace bouguer::server {
std::string scene_key(const api::JobRequest& job) {
    return api::sha256_hex(job.scene_digest + job.files_digest);
}

std::shared_ptr<SceneCache::Entry> SceneCache::use(const std::string& key, std::uint64_t bytes) {
    const std::lock_guard lock(mutex_);
    const auto known = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const auto& entry) { return entry->key == key; });
    if (known != entries_.end()) {
        entries_.splice(entries_.begin(), entries_, known);
    } else {
        entries_.push_front(std::make_shared<Entry>());
        entries_.front()->key = key;
        entries_.front()->bytes = bytes;
    }
    std::uint64_t total = 0;
    for (auto it = entries_.begin(); it != entries_.end();) {
        total += (*it)->bytes;
        // The newest stays, however large: its job is about to use it.
        it = total > max_bytes_ && it != entries_.begin() ? entries_.erase(it) : std::next(it);
    }
    return entries_.front();
}

Result<SceneCache::Scene> SceneCache::get(const std::string& key, std::uint64_t bytes,
                                          const Build& build) {
    const std::shared_ptr<Entry> entry = use(key, bytes);
    const std::lock_guard lock(entry->building);
    if (entry->scene == nullptr) {
        auto built = build();
        if (!built) return tl::unexpected(built.error());
        entry->scene = std::move(*built);
    }
    return entry->scene;
}

}  // namespace bouguer::server
