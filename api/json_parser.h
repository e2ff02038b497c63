// SPDX-License-Identifier: Apache-2.0
// Text -> a JSON tree that is safe to walk: shallow, without duplicate keys, valid UTF-8, every
// number finite.
#pragma once

#include <string_view>

#include "api/json_tree.h"
#include "api/limits.h"
#include "renderer/core/result.h"

namespace bouguer::api {

/// Error{TooLarge}: longer than `limits.body_bytes`. Error{Malformed}: "not-json", "invalid-utf8",
/// "too-deep" (these end the reading), "duplicate-key" (all of them). Error{InvalidInput}:
/// "not-finite" for a number beyond double precision, "over-limit" for keys longer than
/// `limits.name_bytes`. Never throws but std::bad_alloc. Thread-safe.
[[nodiscard]] Result<JsonTree> read_json_tree(std::string_view text, const Limits& limits);

}  // namespace bouguer::api
