// SPDX-License-Identifier: Apache-2.0
#include "server/log_text.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace bouguer::server {
namespace {

struct Range {
    char32_t first, last;
};
/// Categories Cc and Cf of the Unicode standard, and the separators of lines and paragraphs.
constexpr std::array kInvisible{
    Range{0x7f, 0x9f},        // DEL and C1
    Range{0xad, 0xad},        // soft hyphen
    Range{0x600, 0x605},      // Arabic marks of numbers
    Range{0x61c, 0x61c},      // Arabic letter mark
    Range{0x70f, 0x70f},      // Syriac abbreviation mark
    Range{0x180e, 0x180e},    // Mongolian vowel separator
    Range{0x200b, 0x200f},    // no width, marks of direction
    Range{0x2028, 0x202e},    // separators, embeddings and overrides of direction
    Range{0x2060, 0x206f},    // no width, isolates of direction
    Range{0xfeff, 0xfeff},    // byte order mark
    Range{0xfff9, 0xfffb},    // annotations
    Range{0x1d173, 0x1d17a},  // marks of music
    Range{0xe0000, 0xe007f},  // tags
};

bool is_invisible(char32_t c) {
    return std::any_of(kInvisible.begin(), kInvisible.end(),
                       [c](Range range) { return range.first <= c && c <= range.last; });
}

/// Bytes of the character that begins with `first`.
std::size_t length_of(unsigned char first) {
    if (first < 0xc0) return 1;
    if (first < 0xe0) return 2;
    return first < 0xf0 ? 3 : 4;
}

char32_t decode(std::string_view character) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
    if (character.size() == 1) return byte(0);
    char32_t c = byte(0) & (0xffU >> (character.size() + 1));
    for (std::size_t i = 1; i < character.size(); ++i) c = (c << 6U) | (byte(i) & 0x3fU);
    return c;
}

void append_unit(std::string& out, unsigned unit) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    out += "\\u";
    for (int shift = 12; shift >= 0; shift -= 4) out += kDigits[(unit >> shift) & 15U];
}

/// As JSON has it: in UTF-16 [RFC 8259 §7].
void append_escaped(std::string& out, char32_t c) {
    if (c < 0x10000) return append_unit(out, static_cast<unsigned>(c));
    append_unit(out, 0xd800U + ((static_cast<unsigned>(c) - 0x10000U) >> 10U));
    append_unit(out, 0xdc00U + (static_cast<unsigned>(c) & 0x3ffU));
}

}  // namespace

std::string escape_invisible(std::string_view json) {
    std::string out;
    out.reserve(json.size());
    while (!json.empty()) {
        const std::size_t length =
            std::min(length_of(static_cast<unsigned char>(json.front())), json.size());
        const std::string_view character = json.substr(0, length);
        const bool is_whole = length == length_of(static_cast<unsigned char>(json.front()));
        const char32_t c = is_whole ? decode(character) : 0;
        if (is_invisible(c)) {
            append_escaped(out, c);
        } else {
            out += character;
        }
        json.remove_prefix(length);
    }
    return out;
}

}  // namespace bouguer::server
