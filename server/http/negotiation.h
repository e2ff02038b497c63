// SPDX-License-Identifier: Apache-2.0
// Choosing a representation [RFC 9110 §12.5.1].
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace bouguer::server {

/// Index of the offer (a media type, without parameters) that the Accept field likes best; the
/// first of equals, and the first of all when the field is empty. Nothing: none is acceptable.
/// Malformed members of the field are ignored.
[[nodiscard]] std::optional<std::size_t> negotiate(std::string_view accept,
                                                   std::span<const std::string_view> offers);

}  // namespace bouguer::server
