// SPDX-License-Identifier: Apache-2.0
// Content digests: how scenes, jobs, assets and results are named.
#pragma once

#include <string>
#include <string_view>

namespace bouguer::api {

/// Lower-case hexadecimal SHA-256 [FIPS 180-4] of `bytes`.
[[nodiscard]] std::string sha256_hex(std::string_view bytes);

/// "sha256-<hex>" of `bytes`: the name that scenes, jobs and assets have by their content.
[[nodiscard]] std::string digest_of(std::string_view bytes);

/// Whether `text` is of the form of digest_of().
[[nodiscard]] bool is_digest(std::string_view text);

}  // namespace bouguer::api
