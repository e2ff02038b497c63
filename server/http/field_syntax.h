// SPDX-License-Identifier: Apache-2.0
// The small words of HTTP's grammar, read strictly [RFC 9110 §5].
#pragma once

#include <string_view>

namespace bouguer::server {

/// Whether two ASCII strings differ only in case.
[[nodiscard]] bool equal_ignoring_case(std::string_view a, std::string_view b);

/// RFC 9110 §5.6.2: at least one of the characters that names are made of.
[[nodiscard]] bool is_token(std::string_view text);

/// Whether all are what field values are made of [RFC 9110 §5.5]: visible ASCII, space, tab and
/// bytes over 127.
[[nodiscard]] bool is_field_value(std::string_view text);

/// "name: value" [RFC 9112 §5] without the line's end: a field, or a trailer.
[[nodiscard]] bool is_field_line(std::string_view line);

/// "quoted string" [RFC 9110 §5.6.4] with its quotes.
[[nodiscard]] bool is_quoted_string(std::string_view text);

/// Without spaces and tabs around it.
[[nodiscard]] std::string_view trimmed(std::string_view text);

}  // namespace bouguer::server
