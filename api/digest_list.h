// SPDX-License-Identifier: Apache-2.0
// Lists of digests on the wire.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "api/limits.h"
#include "renderer/core/result.h"

namespace bouguer::api {

/// More than these are not asked for at once.
inline constexpr std::size_t kMaxDigests = 1000;

/// Reads {"digests": ["sha256-<hex>", ...]}, at most kMaxDigests. Errors as parse_job.
[[nodiscard]] Result<std::vector<std::string>> parse_digest_list(std::string_view text,
                                                                 const Limits& limits);

/// {"missing": [...]}
[[nodiscard]] std::string missing_json(const std::vector<std::string>& digests);

}  // namespace bouguer::api
