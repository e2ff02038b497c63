// SPDX-License-Identifier: Apache-2.0
// All results of a job as one file: a tar archive (POSIX.1-1988, ustar) whose first member,
// SHA256SUMS, has the digests of the others. By hand: `tar xf ID.tar && sha256sum -c SHA256SUMS`.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/core/result.h"
#include "server/storage/result_store.h"

namespace bouguer::server {

/// Where the bytes of one result stand.
struct ArchivedFile {
    std::uint64_t offset = 0;  ///< from the beginning of the archive
    std::uint64_t bytes = 0;
    std::string digest;  ///< sha256 hex, as it was when they were stored
};

/// An archive in the making: the pieces that follow each other in the file. The bytes of the
/// results are not copied: `files` outlives it.
class ArchiveText {
  public:
    /// `mtime_s`: Unix time that the members are said to be of.
    ArchiveText(const ResultFiles& files, std::int64_t mtime_s);
    ArchiveText(const ArchiveText&) = delete;
    ArchiveText& operator=(const ArchiveText&) = delete;

    [[nodiscard]] const std::vector<std::string_view>& pieces() const { return pieces_; }

  private:
    void add(const std::string& name, std::string_view bytes, std::int64_t mtime_s);

    std::string manifest_;
    std::vector<std::unique_ptr<const std::string>> headers_;
    std::vector<std::string_view> pieces_;
};

/// name -> place of all results in an archive that is open as `fd`; SHA256SUMS itself is not among
/// them. Their bytes are not looked at. Error{Internal}, code "result-damaged": it is no archive of
/// ours, or shorter than it says; "storage-failed": it cannot be read.
[[nodiscard]] Result<std::map<std::string, ArchivedFile>> read_archive(int fd);

/// name -> digest; lines of "<sha256>  <name>", as sha256sum writes them.
[[nodiscard]] std::map<std::string, std::string> read_manifest(const std::string& text);

/// Name of the manifest, in archives and in the folders of earlier versions.
inline constexpr const char* kManifest = "SHA256SUMS";

}  // namespace bouguer::server
