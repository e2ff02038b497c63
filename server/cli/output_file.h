// SPDX-License-Identifier: Apache-2.0
// Writing what the command line was asked for.
#pragma once

#include <filesystem>
#include <string_view>

#include "renderer/core/result.h"

namespace bouguer::server {

/// Regular files are replaced as a whole, also behind links; devices and pipes are written to.
/// Error{Internal}: it cannot be written.
[[nodiscard]] Result<void> write_output(const std::filesystem::path& file, std::string_view bytes);

}  // namespace bouguer::server
