// SPDX-License-Identifier: Apache-2.0
// Files that are on the disk when a function returns.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include "renderer/core/result.h"
#include "server/content.h"
#include "server/file_descriptor.h"

namespace bouguer::server {

/// Writes a new file and flushes it (fsync). Error{Internal}: it exists, disk full, no permission.
[[nodiscard]] Result<void> write_new_file(const std::filesystem::path& file,
                                          std::string_view bytes);
/// The same of pieces that follow each other in the file.
[[nodiscard]] Result<void> write_new_file(const std::filesystem::path& file,
                                          std::span<const std::string_view> pieces);

/// Flushes a folder's entries: after it, renames and new names in it survive a power loss.
[[nodiscard]] Result<void> sync_folder(const std::filesystem::path& folder);

/// Writes beside `file`, flushes, renames over it and flushes the folder: a reader sees the old
/// bytes or the new, never a part.
[[nodiscard]] Result<void> replace_file(const std::filesystem::path& file, std::string_view bytes);

/// Opens a regular file to be read. NotFound; Internal.
[[nodiscard]] Result<FileDescriptor> open_file(const std::filesystem::path& file);

/// "storage-full" or "storage-failed": the stable name of a failure of the disk.
[[nodiscard]] const char* storage_code(const std::error_code& code);

/// A regular file that is at most `max_bytes` long, of which nothing is read yet. NotFound;
/// TooLarge; Internal.
[[nodiscard]] Result<Content> open_content(const std::filesystem::path& file,
                                           std::size_t max_bytes);

/// All bytes of a regular file that is at most `max_bytes` long. NotFound; TooLarge; Internal.
[[nodiscard]] Result<std::string> read_file(const std::filesystem::path& file,
                                            std::size_t max_bytes);

}  // namespace bouguer::server
