// SPDX-License-Identifier: Apache-2.0
// Words and numbers in mesh files, and how a mesh is refused. For the readers of PLY and OBJ only.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "renderer/core/result.h"

namespace bouguer::renderer {

/// "line 7: no such vertex": what is wrong with a mesh and where.
[[nodiscard]] inline tl::unexpected<Error> refuse_mesh(const std::string& where,
                                                       const std::string& what) {
    return fail(ErrorKind::InvalidInput, where.empty() ? what : where + ": " + what, "bad-mesh");
}

/// Without the UTF-8 byte order mark that some writers put before a text [RFC 3629 §6].
[[nodiscard]] inline std::string_view without_mark(std::string_view bytes) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    if (bytes.starts_with(kMark)) bytes.remove_prefix(kMark.size());
    return bytes;
}

inline bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
}

/// Takes words off the front of a text and counts its lines.
class WordScanner {
  public:
    explicit WordScanner(std::string_view text, std::uint64_t line = 1)
        : rest_(text), line_(line) {}

    /// The next word, across lines; empty at the end of the text.
    std::string_view word() {
        std::size_t i = 0;
        for (; i < rest_.size() && is_space(rest_[i]); ++i) line_ += rest_[i] == '\n' ? 1 : 0;
        std::size_t end = i;
        while (end < rest_.size() && !is_space(rest_[end])) ++end;
        const std::string_view found = rest_.substr(i, end - i);
        rest_.remove_prefix(end);
        return found;
    }
    /// The rest of this line without its end; empty optional at the end of the text.
    std::optional<std::string_view> line() {
        if (rest_.empty()) return std::nullopt;
        const std::size_t end = rest_.find('\n');
        std::string_view found = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        line_ += end == std::string_view::npos ? 0 : 1;
        if (!found.empty() && found.back() == '\r') found.remove_suffix(1);
        return found;
    }
    [[nodiscard]] std::string_view rest() const { return rest_; }
    [[nodiscard]] std::uint64_t line_number() const { return line_; }

  private:
    std::string_view rest_;
    std::uint64_t line_;
};

/// The number that `word` is, all of it, whatever the locale; empty when it is none or has no place
/// in `Number`. "nan" and "inf" are numbers here.
template <class Number>
[[nodiscard]] std::optional<Number> parse_number(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    Number value{};
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (error != std::errc{} || stop != end) return std::nullopt;
    return value;
}

/// `word` in quotes and short enough for a message.
[[nodiscard]] inline std::string quoted(std::string_view word) {
    std::string text = "\"";
    for (const char c : word.substr(0, 40)) text += c >= ' ' && c <= '~' ? c : '?';
    return text + (word.size() > 40 ? "...\"" : "\"");
}

}  // namespace bouguer::renderer
