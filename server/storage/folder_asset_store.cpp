// SPDX-License-Identifier: Apache-2.0
#include "server/storage/folder_asset_store.h"

#include <unistd.h>

#include "api/digest.h"
#include "server/storage/durable_file.h"

namespace bouguer::server {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPartPrefix = ".part-asset-";

tl::unexpected<Error> failed(const std::error_code& code) {
    return fail(ErrorKind::Internal, "the asset store failed: " + code.message(), "storage-failed");
}

}  // namespace

Result<std::unique_ptr<FolderAssetStore>> FolderAssetStore::open(fs::path root,
                                                                 const AssetStoreLimits& limits) {
    try {
        fs::create_directories(root);
        std::unique_ptr<FolderAssetStore> store(new FolderAssetStore(std::move(root), limits));
        store->count_files();
        return store;
    } catch (const fs::filesystem_error& e) {
        return failed(e.code());
    }
}

void FolderAssetStore::count_files() {
    for (const auto& entry : fs::directory_iterator(root_)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with(kPartPrefix)) {
            fs::remove(entry.path());
        } else if (api::is_digest(name) && entry.is_regular_file()) {
            total_bytes_ += entry.file_size();
        }
    }
}

bool FolderAssetStore::take_room(std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    if (total_bytes_ + bytes > limits_.total_bytes) return false;
    total_bytes_ += bytes;
    return true;
}

void FolderAssetStore::give_room_back(std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    total_bytes_ -= bytes;
}

fs::path FolderAssetStore::new_part() {
    const std::lock_guard lock(mutex_);
    return root_ / (kPartPrefix + std::to_string(::getpid()) + "-" + std::to_string(++num_parts_));
}

Result<AssetStore::Put> FolderAssetStore::put(const std::string& digest, std::string_view bytes) {
    if (auto good = check_asset(digest, bytes, limits_); !good) {
        return tl::unexpected(std::move(good).error());
    }
    if (has(digest)) return Put::Known;
    if (!take_room(bytes.size())) return asset_store_is_full(limits_);
    auto written = write(digest, bytes);
    if (!written || *written == Put::Known) give_room_back(bytes.size());
    return written;
}

Result<AssetStore::Put> FolderAssetStore::write(const std::string& digest, std::string_view bytes) {
    const fs::path part = new_part();
    std::error_code error;
    if (auto written = write_new_file(part, bytes); !written) {
        fs::remove(part, error);
        // also when the folder is gone: what is not found is not the client's file
        return fail(ErrorKind::Internal, written.error().message, written.error().code);
    }
    // A link, unlike a rename, never takes the place of a file: of two that put the same bytes at
    // the same time one is the first.
    fs::create_hard_link(part, root_ / digest, error);
    std::error_code ignored;
    fs::remove(part, ignored);
    if (error == std::errc::file_exists) return Put::Known;
    if (error) return failed(error);
    if (auto synced = sync_folder(root_); !synced) {
        return tl::unexpected(std::move(synced).error());
    }
    return Put::New;
}

Result<std::string> FolderAssetStore::get(const std::string& digest) const {
    if (!has(digest)) return fail(ErrorKind::NotFound, "no such asset");
    auto bytes = read_file(root_ / digest, limits_.file_bytes);
    if (bytes && api::digest_of(*bytes) == digest) return bytes;
    return fail(ErrorKind::Internal, "the stored asset is damaged", "asset-damaged");
}

bool FolderAssetStore::has(const std::string& digest) const {
    std::error_code ignored;
    return api::is_digest(digest) && fs::is_regular_file(root_ / digest, ignored);
}

}  // namespace bouguer::server
