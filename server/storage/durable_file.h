// SPDX-License-Identifier: Apache-2.0
// Files that are on the disk when a function returns.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "renderer/core/result.h"

namespace bouguer::server {

/// Writes a new file and flushes it (fsync). Error{Internal}: it exists, disk full, no permission.
[[nodiscard]] Result<void> write_new_file(const std::filesystem::path& file,
                                          std::string_view bytes);

/// Flushes a folder's entries: after it, renames and new names in it survive a power loss.
[[nodiscard]] Result<void> sync_folder(const std::filesystem::path& folder);

/// Writes beside `file`, flushes, renames over it and flushes the folder: a reader sees the old
/// bytes or the new, never a part.
[[nodiscard]] Result<void> replace_file(const std::filesystem::path& file, std::string_view bytes);

/// All bytes of a regular file that is at most `max_bytes` long. NotFound; TooLarge; Internal.
[[nodiscard]] Result<std::string> read_file(const std::filesystem::path& file,
                                            std::size_t max_bytes);

}  // namespace bouguer::server
