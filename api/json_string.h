// SPDX-License-Identifier: Apache-2.0
// Strings as JSON has them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace bouguer::api {

/// `text` as a JSON string, quoted and escaped; bytes that are no UTF-8 are replaced.
[[nodiscard]] std::string json_string(std::string_view text);

/// Likewise in ASCII, with escapes for all else.
[[nodiscard]] std::string ascii_json_string(std::string_view text);

/// The longest prefix of at most `bytes` bytes that does not cut a UTF-8 sequence.
[[nodiscard]] std::string_view utf8_prefix(std::string_view text, std::size_t bytes);

}  // namespace bouguer::api
