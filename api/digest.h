// SPDX-License-Identifier: Apache-2.0
// Content digests: how scenes, jobs and results are named.
#pragma once

#include <string>
#include <string_view>

namespace bouguer::api {

/// Lower-case hexadecimal SHA-256 [FIPS 180-4] of `bytes`.
[[nodiscard]] std::string sha256_hex(std::string_view bytes);

}  // namespace bouguer::api
