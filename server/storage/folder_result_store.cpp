// SPDX-License-Identifier: Apache-2.0
#include "server/storage/folder_result_store.h"

#include <limits>
#include <sstream>

#include "api/digest.h"
#include "server/jobs/job_id.h"
#include "server/storage/durable_file.h"

namespace bouguer::server {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifest = "SHA256SUMS";
constexpr const char* kPartPrefix = ".part-";

tl::unexpected<Error> no_such_result() { return fail(ErrorKind::NotFound, "no such result"); }

/// Runs `work` and turns what std::filesystem throws into an error of the environment.
template <class Work>
auto guarded(Work&& work) -> decltype(work()) {
    try {
        return work();
    } catch (const fs::filesystem_error& e) {
        return fail(ErrorKind::Internal, "the result store failed: " + e.code().message(),
                    "storage-failed");
    }
}

/// name -> digest; lines of "<sha256>  <name>", as sha256sum writes them.
Result<std::map<std::string, std::string>> read_manifest(const fs::path& folder) {
    auto text = read_file(folder / kManifest, std::size_t{1} << 20U);
    if (!text) return tl::unexpected(text.error());
    std::map<std::string, std::string> digests;
    std::istringstream lines(*text);
    std::string digest;
    std::string name;
    while (lines >> digest >> name) digests[name] = digest;
    return digests;
}

Result<void> write_files(const fs::path& folder, const ResultFiles& files) {
    std::string manifest;
    for (const auto& [name, bytes] : files) {
        if (auto written = write_new_file(folder / name, bytes); !written) return written;
        manifest += api::sha256_hex(bytes) + "  " + name + "\n";
    }
    if (auto written = write_new_file(folder / kManifest, manifest); !written) return written;
    return sync_folder(folder);
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

Result<void> FolderResultStore::put(const JobId& id, const ResultFiles& files) {
    if (auto good = check_results(id, files); !good) return good;
    return guarded([&]() -> Result<void> {
        const fs::path part = root_ / (kPartPrefix + id);
        fs::remove_all(part);
        fs::create_directory(part);
        if (auto written = write_files(part, files); !written) {
            fs::remove_all(part);
            return written;
        }
        // A crash between these two lines leaves the job without results; it is not done yet then
        // and is rendered again.
        fs::remove_all(root_ / id);
        fs::rename(part, root_ / id);
        return sync_folder(root_);
    });
}

Result<StoredFile> FolderResultStore::get(const JobId& id, const std::string& name) const {
    if (!is_job_id(id) || !is_result_name(name)) return no_such_result();
    auto manifest = read_manifest(root_ / id);
    if (!manifest) return tl::unexpected(manifest.error());
    const auto entry = manifest->find(name);
    if (entry == manifest->end()) return no_such_result();
    auto bytes = read_file(root_ / id / name, std::numeric_limits<std::size_t>::max());
    // Removed since the manifest was read.
    if (!bytes && !std::filesystem::exists(root_ / id)) return no_such_result();
    if (!bytes || api::sha256_hex(*bytes) != entry->second) {
        return fail(ErrorKind::Internal, "the stored " + name + " is damaged", "result-damaged");
    }
    return StoredFile{std::move(*bytes), entry->second};
}

Result<std::vector<std::string>> FolderResultStore::names(const JobId& id) const {
    std::vector<std::string> names;
    if (!is_job_id(id)) return names;
    auto manifest = read_manifest(root_ / id);
    if (!manifest) {
        if (manifest.error().kind == ErrorKind::NotFound) return names;
        return tl::unexpected(manifest.error());
    }
    for (const auto& [name, digest] : *manifest) names.push_back(name);
    return names;
}

Result<void> FolderResultStore::remove(const JobId& id) {
    if (!is_job_id(id)) return {};
    return guarded([&]() -> Result<void> {
        fs::remove_all(root_ / id);
        return sync_folder(root_);
    });
}

}  // namespace bouguer::server
