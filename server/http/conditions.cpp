// SPDX-License-Identifier: Apache-2.0
#include "server/http/conditions.h"

#include <algorithm>
#include <string_view>

#include "server/http/field_syntax.h"

namespace bouguer::server {
namespace {

constexpr std::string_view kWeak = "W/";

enum class Comparison { Strong, Weak };

/// Cuts the first member off a list: up to the first comma that is not in quotes, where an entity
/// tag has no escapes [RFC 9110 §8.8.3].
std::string_view next_tag(std::string_view& list) {
    bool quoted = false;
    std::size_t end = 0;
    for (; end < list.size() && (quoted || list[end] != ','); ++end) {
        if (list[end] == '"') quoted = !quoted;
    }
    const std::string_view tag = trimmed(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
    return tag;
}

/// Whether one line of the field names `tag`, or anything ("*").
bool names(std::string_view line, std::string_view tag, Comparison comparison) {
    if (trimmed(line) == "*") return true;
    while (!line.empty()) {
        std::string_view named = next_tag(line);
        if (comparison == Comparison::Weak && named.starts_with(kWeak)) {
            named.remove_prefix(kWeak.size());
        }
        if (named == tag) return true;
    }
    return false;
}

/// A list may come in several lines [RFC 9110 §5.3].
bool any_names(const httplib::Request& request, const std::string& field, std::string_view tag,
               Comparison comparison) {
    const auto [begin, end] = request.headers.equal_range(field);
    return std::any_of(begin, end,
                       [&](const auto& header) { return names(header.second, tag, comparison); });
}

}  // namespace

bool if_match_holds(const httplib::Request& request, const std::string& tag) {
    return !request.has_header("If-Match") ||
           any_names(request, "If-Match", tag, Comparison::Strong);
}

bool if_none_match_names(const httplib::Request& request, const std::string& tag) {
    return any_names(request, "If-None-Match", tag, Comparison::Weak);
}

Refusal precondition_failed() {
    return {412, "precondition-failed",
            "What is here now is not what the request expects: ask again for its ETag."};
}

bool has_conditions(const httplib::Request& request) {
    return request.has_header("If-Match") || request.has_header("If-None-Match");
}

std::optional<Refusal> refused_by_condition(const httplib::Request& request,
                                            const std::optional<std::string>& tag) {
    const bool holds = tag ? if_match_holds(request, *tag) && !if_none_match_names(request, *tag)
                           : !request.has_header("If-Match");
    return holds ? std::nullopt : std::optional(precondition_failed());
}

}  // namespace bouguer::server
