// SPDX-License-Identifier: Apache-2.0
#include "server/storage/folder_result_store.h"

#include <fcntl.h>

#include "api/running_digest.h"
#include "server/jobs/job_id.h"
#include "server/storage/durable_file.h"
#include "server/utc_time.h"

namespace bouguer::server {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPartPrefix = ".part-";
constexpr const char* kSuffix = ".tar";
constexpr std::size_t kPieceBytes = std::size_t{256} << 10U;
/// Parts of files that are remembered as checked.
constexpr std::size_t kMostChecked = 100'000;

tl::unexpected<Error> no_such_result() { return fail(ErrorKind::NotFound, "no such result"); }

tl::unexpected<Error> damaged(const std::string& name) {
    return fail(ErrorKind::Internal, "the stored " + name + " is damaged", "result-damaged");
}

/// Runs `work` and turns what std::filesystem throws into an error of the environment.
template <class Work>
auto guarded(Work&& work) -> decltype(work()) {
    try {
        return work();
    } catch (const fs::filesystem_error& e) {
        return fail(ErrorKind::Internal, "the result store failed: " + e.code().message(),
                    storage_code(e.code()));
    }
}

/// The results of a job as earlier versions stored them: a file each, in a folder.
Result<std::map<std::string, std::string>> read_old_manifest(const fs::path& folder) {
    auto text = read_file(folder / kManifest, std::size_t{1} << 20U);
    if (text) return read_manifest(*text);
    std::error_code ignored;
    if (text.error().kind == ErrorKind::NotFound && fs::exists(folder, ignored)) {
        return damaged(kManifest);
    }
    return tl::unexpected(text.error());
}

}  // namespace

Result<std::unique_ptr<FolderResultStore>> FolderResultStore::open(fs::path root) {
    return guarded([&]() -> Result<std::unique_ptr<FolderResultStore>> {
        fs::create_directories(root);
        for (const auto& entry : fs::directory_iterator(root)) {
            if (entry.path().filename().string().starts_with(kPartPrefix)) {
                fs::remove_all(entry.path());
            }
        }
        return std::unique_ptr<FolderResultStore>(new FolderResultStore(std::move(root)));
    });
}

fs::path FolderResultStore::archive_of(const JobId& id) const { return root_ / (id + kSuffix); }

Result<void> FolderResultStore::put(const JobId& id, const ResultFiles& files) {
    if (auto good = check_results(id, files); !good) return good;
    return guarded([&]() -> Result<void> {
        const fs::path part = root_ / (kPartPrefix + id);
        fs::remove_all(part);
        const ArchiveText archive(files, unix_ms() / 1000);
        if (auto written = write_new_file(part, archive.pieces()); !written) {
            std::error_code ignored;
            fs::remove(part, ignored);
            // also when the folder is gone: nothing was asked for that could be missing
            return fail(ErrorKind::Internal, written.error().message, written.error().code);
        }
        fs::rename(part, archive_of(id));
        return sync_folder(root_);
    });
}

Result<FolderResultStore::Place> FolderResultStore::find(const JobId& id,
                                                         const std::string& name) const {
    if (!is_job_id(id) || !is_result_name(name)) return no_such_result();
    auto archive = open_file(archive_of(id));
    if (archive) {
        auto files = read_archive(archive->get());
        if (!files) return tl::unexpected(files.error());
        const auto found = files->find(name);
        if (found == files->end()) return no_such_result();
        return Place{std::make_shared<const FileDescriptor>(std::move(*archive)), found->second};
    }
    if (archive.error().kind != ErrorKind::NotFound) return tl::unexpected(archive.error());
    const auto manifest = read_old_manifest(root_ / id);
    if (!manifest) return tl::unexpected(manifest.error());
    const auto found = manifest->find(name);
    if (found == manifest->end()) return no_such_result();
    auto file = open_file(root_ / id / name);
    if (!file && file.error().kind == ErrorKind::NotFound) return damaged(name);
    if (!file) return tl::unexpected(file.error());
    struct stat info {};
    if (::fstat(file->get(), &info) != 0) return damaged(name);
    return Place{std::make_shared<const FileDescriptor>(std::move(*file)),
                 {0, static_cast<std::uint64_t>(info.st_size), found->second}};
}

Result<void> FolderResultStore::check(const Place& place, const Content& content,
                                      const std::string& name) const {
    struct stat info {};
    if (::fstat(place.file->get(), &info) != 0) return damaged(name);
    const Checked key{info.st_dev, info.st_ino,
                      info.st_ctim.tv_sec * 1'000'000'000 + info.st_ctim.tv_nsec, info.st_size,
                      place.where.offset};
    {
        const std::lock_guard lock(mutex_);
        if (checked_.contains(key)) return {};
    }
    api::RunningDigest digest;
    std::string piece;
    for (std::size_t at = 0; at < content.size(); at += kPieceBytes) {
        piece.clear();
        if (!content.read(at, kPieceBytes, piece)) return damaged(name);
        digest.add(piece);
    }
    if (digest.hex() != place.where.digest) return damaged(name);
    const std::lock_guard lock(mutex_);
    if (checked_.size() >= kMostChecked) checked_.clear();
    checked_.insert(key);
    return {};
}

Result<StoredFile> FolderResultStore::get(const JobId& id, const std::string& name) const {
    auto place = find(id, name);
    if (!place) return tl::unexpected(place.error());
    Content content(place->file, place->where.offset, static_cast<std::size_t>(place->where.bytes));
    if (auto good = check(*place, content, name); !good) return tl::unexpected(good.error());
    return StoredFile{std::move(content), place->where.digest};
}

Result<std::vector<std::string>> FolderResultStore::names(const JobId& id) const {
    std::vector<std::string> names;
    if (!is_job_id(id)) return names;
    const auto archive = open_file(archive_of(id));
    if (archive) {
        const auto files = read_archive(archive->get());
        if (!files) return tl::unexpected(files.error());
        for (const auto& [name, where] : *files) names.push_back(name);
        return names;
    }
    if (archive.error().kind != ErrorKind::NotFound) return tl::unexpected(archive.error());
    const auto manifest = read_old_manifest(root_ / id);
    if (!manifest && manifest.error().kind == ErrorKind::NotFound) return names;
    if (!manifest) return tl::unexpected(manifest.error());
    for (const auto& [name, digest] : *manifest) names.push_back(name);
    return names;
}

Result<void> FolderResultStore::remove(const JobId& id) {
    if (!is_job_id(id)) return {};
    return guarded([&]() -> Result<void> {
        fs::remove(archive_of(id));
        fs::remove_all(root_ / id);
        return sync_folder(root_);
    });
}

Result<std::vector<JobId>> FolderResultStore::jobs() const {
    return guarded([&]() -> Result<std::vector<JobId>> {
        std::vector<JobId> ids;
        for (const auto& entry : fs::directory_iterator(root_)) {
            std::string name = entry.path().filename().string();
            if (name.ends_with(kSuffix)) name.resize(name.size() - std::string(kSuffix).size());
            if (is_job_id(name)) ids.push_back(std::move(name));
        }
        return ids;
    });
}

Result<void> FolderResultStore::set_aside(const JobId& id) {
    if (!is_job_id(id)) return {};
    return guarded([&]() -> Result<void> {
        const fs::path aside = root_.parent_path() / "lost-results";
        fs::create_directories(aside);
        for (const fs::path& path : {archive_of(id), root_ / id}) {
            if (fs::exists(path)) fs::rename(path, aside / path.filename());
        }
        return sync_folder(root_);
    });
}

}  // namespace bouguer::server
