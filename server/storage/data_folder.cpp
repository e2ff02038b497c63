// SPDX-License-Identifier: Apache-2.0
#include "server/storage/data_folder.h"

#include <sys/stat.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace bouguer::server {
namespace {

tl::unexpected<Error> failed(const std::string& message) {
    return fail(ErrorKind::Internal, message, "storage-failed");
}

}  // namespace

std::uint64_t reserved_bytes(std::uint64_t disk_bytes) {
    return std::min<std::uint64_t>(64U << 20U, disk_bytes / 20);
}

Result<DataFolder::Entry> DataFolder::look_at(const std::filesystem::path& path) {
    struct stat info {};
    if (::stat(path.c_str(), &info) != 0) {
        return failed("cannot find " + path.filename().string() +
                      " of the data folder: " + std::strerror(errno));
    }
    return Entry{path, info.st_dev, info.st_ino};
}

Result<DataFolder> DataFolder::open(std::vector<std::filesystem::path> entries) {
    std::vector<Entry> found;
    for (const std::filesystem::path& path : entries) {
        auto entry = look_at(path);
        if (!entry) return tl::unexpected(entry.error());
        found.push_back(std::move(*entry));
    }
    return DataFolder(std::move(found));
}

Result<void> DataFolder::check() const {
    for (const Entry& entry : entries_) {
        const auto now = look_at(entry.path);
        if (!now) return tl::unexpected(now.error());
        if (now->device != entry.device || now->inode != entry.inode) {
            return failed(entry.path.filename().string() +
                          " of the data folder is not the one that was opened");
        }
    }
    struct statvfs disk {};
    if (::statvfs(entries_.front().path.c_str(), &disk) != 0) {
        return failed(std::string("cannot ask for the free space: ") + std::strerror(errno));
    }
    const std::uint64_t free_bytes = disk.f_bavail * disk.f_frsize;
    const std::uint64_t reserved = reserved_bytes(disk.f_blocks * disk.f_frsize);
    if (free_bytes >= reserved) return {};
    return fail(ErrorKind::Internal,
                "only " + std::to_string(free_bytes >> 10U) +
                    " KiB are free on the disk; new jobs are taken when it is " +
                    std::to_string(reserved >> 10U),
                "storage-full");
}

}  // namespace bouguer::server
