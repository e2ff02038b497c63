// SPDX-License-Identifier: Apache-2.0
#include "server/storage/folder_asset_source.h"

#include <algorithm>
#include <utility>

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

class OpenFile final : public renderer::ByteSource {
  public:
    explicit OpenFile(Content content) : content_(std::move(content)) {}
    [[nodiscard]] std::uint64_t size() const override { return content_.size(); }
    [[nodiscard]] Result<std::string> read(std::uint64_t offset, std::size_t count) const override {
        std::string bytes;
        if (auto got = content_.read(offset, count, bytes); !got) {
            return tl::unexpected(std::move(got).error());
        }
        return bytes;
    }

  private:
    Content content_;
};

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

Result<std::unique_ptr<const renderer::ByteSource>> FolderAssetSource::open(
    std::string_view name) const {
    const auto file = resolve(name);
    if (!file) return tl::unexpected(file.error());
    auto content = open_content(*file, max_file_bytes_);
    if (!content) return tl::unexpected(std::move(content).error());
    return std::make_unique<const OpenFile>(*std::move(content));
}

}  // namespace bouguer::server
