// SPDX-License-Identifier: Apache-2.0
#include "server/http/query.h"

#include <algorithm>
#include <charconv>
#include <vector>

namespace bouguer::server {
namespace {

constexpr std::string_view kOnlyForBrowsers = "v";

Error invalid_query(std::vector<Problem> problems) {
    return {.kind = ErrorKind::InvalidInput,
            .message = "The query is not acceptable.",
            .problems = std::move(problems),
            .code = "invalid-query"};
}

std::string about(std::string_view name) { return "query parameter " + std::string(name); }

/// The first part of `rest`, which loses it and the separator.
std::string_view cut(std::string_view& rest, char separator) {
    const std::size_t end = std::min(rest.find(separator), rest.size());
    const std::string_view part = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return part;
}

std::string decoded(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        unsigned char byte = text[i] == '+' ? ' ' : text[i];
        if (byte == '%' && i + 2 < text.size()) {
            std::from_chars(text.data() + i + 1, text.data() + i + 3, byte, 16);
            i += 2;
        }
        out += static_cast<char>(byte);
    }
    return out;
}

}  // namespace

httplib::Params params_of(std::string_view target) {
    httplib::Params params;
    (void)cut(target, '?');
    while (!target.empty()) {
        std::string_view text = cut(target, '&');
        if (text.empty()) continue;
        std::string name = decoded(cut(text, '='));
        params.emplace(std::move(name), decoded(text));
    }
    return params;
}

Error bad_parameter(const std::string& name, std::string code, std::string found,
                    std::string allowed) {
    return invalid_query({{.pointer = "",
                           .code = std::move(code),
                           .detail = about(name) + " is not acceptable",
                           .found = std::move(found),
                           .allowed = std::move(allowed)}});
}

Error bad_query(Error error) {
    for (Problem& problem : error.problems) {
        // "/white/0": the parameter is the first token
        const std::size_t end = std::min(problem.pointer.find('/', 1), problem.pointer.size());
        problem.detail = about(problem.pointer.substr(1, end - 1)) + ": " + problem.detail;
        problem.pointer.clear();
    }
    return invalid_query(std::move(error.problems));
}

Result<std::map<std::string, std::string>> query_of(const httplib::Request& request) {
    std::map<std::string, std::string> query;
    for (const auto& [name, text] : request.params) {
        if (name == kOnlyForBrowsers) continue;
        if (!query.emplace(name, text).second) {
            return tl::unexpected(bad_parameter(name, "duplicate-key", text, "one value"));
        }
    }
    return query;
}

Result<std::string> take_required(std::map<std::string, std::string>& query,
                                  const std::string& name, const std::string& allowed) {
    auto taken = query.extract(name);
    if (taken.empty()) return tl::unexpected(bad_parameter(name, "missing", "", allowed));
    return std::move(taken.mapped());
}

std::optional<std::string> take_optional(std::map<std::string, std::string>& query,
                                         const std::string& name) {
    auto taken = query.extract(name);
    return taken.empty() ? std::nullopt : std::optional(std::move(taken.mapped()));
}

Result<void> expect_empty(const std::map<std::string, std::string>& query) {
    if (query.empty()) return {};
    std::vector<Problem> problems;
    for (const auto& [name, text] : query) {
        problems.push_back({.pointer = "",
                            .code = "unknown-key",
                            .detail = about(name) + " has no meaning here",
                            .found = text,
                            .allowed = ""});
    }
    return tl::unexpected(invalid_query(std::move(problems)));
}

}  // namespace bouguer::server
