// SPDX-License-Identifier: Apache-2.0
// JSON values as text: the one form that digests are made of, and what people are told.
#pragma once

#include <string>
#include <string_view>

#include "api/json_tree.h"

namespace bouguer::api {

/// `value` on one line, keys sorted, numbers as short as they round-trip.
[[nodiscard]] std::string canonical_text(const Json& value);

/// What stands there, for people, in at most about 80 bytes: scalars as JSON, strings cut, "an
/// array of 3", "an object".
[[nodiscard]] std::string describe(const Json& value);
/// Likewise of the string `text`.
[[nodiscard]] std::string describe_text(std::string_view text);

}  // namespace bouguer::api
