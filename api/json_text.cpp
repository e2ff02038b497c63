// SPDX-License-Identifier: Apache-2.0
#include "api/json_text.h"

#include <algorithm>
#include <array>
#include <nlohmann/detail/conversions/to_chars.hpp>
#include <utility>

#include "api/json_string.h"

namespace bouguer::api {
namespace {

constexpr std::size_t kLongestFound = 60;

bool is_plain(char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; }

void append_string(std::string& out, std::string_view text) {
    if (!std::all_of(text.begin(), text.end(), is_plain)) {
        out += json_string(text);
        return;
    }
    out += '"';
    out += text;
    out += '"';
}

/// The digits of doubles are those of the library that has made the digests of all documents so
/// far.
void append_number(std::string& out, const Json& value) {
    if (!value.is_whole()) {
        std::array<char, 64> digits{};
        const char* end = nlohmann::detail::to_chars(digits.data(), digits.data() + digits.size(),
                                                     value.number());
        out.append(static_cast<const char*>(digits.data()), end);
    } else if (const auto integer = value.integer()) {
        out += std::to_string(*integer);
    } else {
        out += std::to_string(value.large());
    }
}

// As deep as the document, which the parser limits.
void append(std::string& out, const Json& value) {
    if (value.is_object()) {
        char before = '{';
        for (const auto& [key, member] : value.members()) {
            out += std::exchange(before, ',');
            append_string(out, key);
            out += ':';
            append(out, member);
        }
        out += before == '{' ? "{}" : "}";
    } else if (value.is_array()) {
        out += '[';
        for (std::size_t i = 0; i < value.size(); ++i) {
            if (i > 0) out += ',';
            append(out, value[i]);
        }
        out += ']';
    } else if (value.is_string()) {
        append_string(out, value.text());
    } else if (value.is_number()) {
        append_number(out, value);
    } else {
        out += value.is_null() ? "null" : value.boolean() ? "true" : "false";
    }
}

}  // namespace

std::string canonical_text(const Json& value) {
    std::string text;
    append(text, value);
    return text;
}

std::string describe(const Json& value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return "an array of " + std::to_string(value.size());
    return value.is_string() ? describe_text(value.text()) : canonical_text(value);
}

std::string describe_text(std::string_view text) {
    const std::string_view shown = utf8_prefix(text, kLongestFound);
    return ascii_json_string(shown) + (shown.size() < text.size() ? " ..." : "");
}

}  // namespace bouguer::api
