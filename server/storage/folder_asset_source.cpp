// SPDX-License-Identifier: Apache-2.0
#include "server/storage/folder_asset_source.h"

#include <algorithm>

#include "api/digest.h"
#include "server/storage/durable_file.h"

namespace bouguer::server {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxNameBytes = 1024;

/// Whether `name` is relative and stays, as it is written, below where it starts.
bool is_below(std::string_view name) {
    if (name.empty() || name.size() > kMaxNameBytes) return false;
    if (name.find('\0') != std::string_view::npos) return false;
    const fs::path path(name);
    return path.is_relative() && std::none_of(path.begin(), path.end(),
                                              [](const fs::path& part) { return part == ".."; });
}

/// Whether `path` is `root` or below it; both canonical.
bool contains(const fs::path& root, const fs::path& path) {
    return std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
}

}  // namespace

Result<fs::path> FolderAssetSource::resolve(std::string_view name) const {
    if (!is_below(name)) {
        return fail(ErrorKind::InvalidInput, "a file's name must be relative and without \"..\"",
                    "bad-asset-name");
    }
    std::error_code error;
    const bool is_upload = api::is_digest(name) && !uploads_.empty();
    const fs::path root = fs::canonical(is_upload ? uploads_ : root_, error);
    const fs::path file = error ? fs::path() : fs::canonical(root / fs::path(name), error);
    // What lies outside is said to be missing, so that nobody learns what exists elsewhere.
    if (error || !contains(root, file)) {
        return fail(ErrorKind::NotFound, "there is no such file among the assets");
    }
    return file;
}

Result<std::string> FolderAssetSource::read(std::string_view name) const {
    auto file = resolve(name);
    if (!file) return tl::unexpected(file.error());
    return read_file(*file, max_file_bytes_);
}

}  // namespace bouguer::server
