// SPDX-License-Identifier: Apache-2.0
// The clock on the wall, for people and for records. Never for durations.
#pragma once

#include <cstdint>
#include <string>

namespace bouguer::server {

/// Milliseconds of Unix time now.
[[nodiscard]] std::int64_t unix_ms();

/// RFC 3339 in UTC: "2026-01-31T23:59:59.123Z".
[[nodiscard]] std::string utc_text(std::int64_t unix_ms);

}  // namespace bouguer::server
