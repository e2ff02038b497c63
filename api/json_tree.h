// SPDX-License-Identifier: Apache-2.0
// Text -> a JSON tree that is safe to walk: shallow, without duplicate keys, valid UTF-8, every
// number finite.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "api/limits.h"
#include "renderer/core/result.h"

namespace bouguer::api {

using Json = nlohmann::json;

/// Error{TooLarge}: longer than `limits.body_bytes`. Error{Malformed}: "not-json", "invalid-utf8",
/// "too-deep" (these end the reading), "duplicate-key" (all of them). Error{InvalidInput}:
/// "not-finite" for a number beyond double precision, "over-limit" for keys longer than
/// `limits.name_bytes`. Never throws but for lack of memory. Thread-safe.
[[nodiscard]] Result<Json> read_json_tree(std::string_view text, const Limits& limits);

/// `value` on one line, keys sorted, numbers as short as they round-trip. Bytes that are no UTF-8
/// are replaced.
[[nodiscard]] std::string canonical_text(const Json& value);

/// What stands there, for people, in at most about 80 bytes: scalars as JSON, strings cut, "an
/// array of 3", "an object".
[[nodiscard]] std::string describe(const Json& value);

}  // namespace bouguer::api
