// SPDX-License-Identifier: Apache-2.0
#include "server/storage/memory_asset_store.h"

namespace bouguer::server {

Result<AssetStore::Put> MemoryAssetStore::put(const std::string& digest, std::string_view bytes) {
    if (auto good = check_asset(digest, bytes, limits_); !good) {
        return tl::unexpected(std::move(good).error());
    }
    const std::lock_guard lock(mutex_);
    if (files_.contains(digest)) return Put::Known;
    if (total_bytes_ + bytes.size() > limits_.total_bytes) return asset_store_is_full(limits_);
    files_.emplace(digest, bytes);
    total_bytes_ += bytes.size();
    return Put::New;
}

Result<std::string> MemoryAssetStore::get(const std::string& digest) const {
    const std::lock_guard lock(mutex_);
    const auto file = files_.find(digest);
    if (file == files_.end()) return fail(ErrorKind::NotFound, "no such asset");
    return file->second;
}

bool MemoryAssetStore::has(const std::string& digest) const {
    const std::lock_guard lock(mutex_);
    return files_.contains(digest);
}

}  // namespace bouguer::server
