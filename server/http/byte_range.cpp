// SPDX-License-Identifier: Apache-2.0
#include "server/http/byte_range.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>

namespace bouguer::server {
namespace {

/// Digits only; a number beyond 64 bits is the largest there is.
std::optional<std::uint64_t> number(std::string_view text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || end != text.data() + text.size()) return std::nullopt;
    if (error == std::errc::result_out_of_range) return std::numeric_limits<std::uint64_t>::max();
    return error == std::errc{} ? std::optional(value) : std::nullopt;
}

RangeRequest part(std::uint64_t first, std::uint64_t last, std::size_t size) {
    if (first >= size) return {RangeRequest::Kind::NotSatisfiable, {}};
    const std::uint64_t end = std::min<std::uint64_t>(last, size - 1) + 1;
    return {RangeRequest::Kind::Part, {first, end - first}};
}

RangeRequest suffix(std::uint64_t length, std::size_t size) {
    if (length == 0 || size == 0) return {RangeRequest::Kind::NotSatisfiable, {}};
    const std::uint64_t n = std::min<std::uint64_t>(length, size);
    return {RangeRequest::Kind::Part, {size - n, n}};
}

}  // namespace

RangeRequest parse_range_field(std::string_view field, std::size_t size) {
    constexpr std::string_view kUnit = "bytes=";
    if (field.substr(0, kUnit.size()) != kUnit) return {};
    field.remove_prefix(kUnit.size());
    const auto dash = field.find('-');
    if (dash == std::string_view::npos) return {};
    const auto first = number(field.substr(0, dash));
    const auto last = number(field.substr(dash + 1));
    if (dash == 0) return last ? suffix(*last, size) : RangeRequest{};
    if (!first) return {};
    if (dash + 1 == field.size()) {
        return part(*first, std::numeric_limits<std::uint64_t>::max(), size);
    }
    if (!last || *last < *first) return {};
    return part(*first, *last, size);
}

}  // namespace bouguer::server
