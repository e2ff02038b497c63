// SPDX-License-Identifier: Apache-2.0
// Text of clients in the log: nothing in it may change how a terminal or an editor shows the rest.
#pragma once

#include <string>
#include <string_view>

namespace bouguer::server {

/// The JSON text with \u escapes in place of control characters beyond ASCII's, of marks that turn
/// the direction of writing (U+202E ...), of line separators and of what has no width. They can
/// only stand inside strings, so the document stays the same. `json` is UTF-8 and without ASCII
/// control characters but DEL, as api::JsonObject makes it.
[[nodiscard]] std::string escape_invisible(std::string_view json);

}  // namespace bouguer::server
