// SPDX-License-Identifier: Apache-2.0
// Parts of a result [RFC 9110 §14].
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace bouguer::server {

struct ByteRange {
    std::size_t first = 0, length = 0;
    bool operator==(const ByteRange&) const = default;
};

/// What a Range field asks of `size` bytes.
struct RangeRequest {
    enum class Kind {
        Whole,           ///< no range, several of them, or another unit: the whole is sent
        Part,            ///< `range`, already clamped to the size
        NotSatisfiable,  ///< begins behind the end: 416
    };
    Kind kind = Kind::Whole;
    ByteRange range;
};

/// `field`: the value of the Range field; empty means none.
[[nodiscard]] RangeRequest parse_range_field(std::string_view field, std::size_t size);

}  // namespace bouguer::server
