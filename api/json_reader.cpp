// SPDX-License-Identifier: Apache-2.0
#include "api/json_reader.h"

#include <algorithm>

#include "api/json_text.h"
#include "api/nearest_name.h"

namespace bouguer::api {

JsonReader::JsonReader(JsonValue value) : value_(std::move(value)) {
    if (!is_object()) value_.report_type("an object");
}

std::optional<JsonValue> JsonReader::find(std::string_view key) {
    if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.push_back(key);
    if (!is_object() || !value_.json().contains(key)) return std::nullopt;
    return value_.member(key);
}

std::optional<JsonValue> JsonReader::require(std::string_view key) {
    auto member = find(key);
    if (!member && is_object()) {
        value_.problems().add({value_.pointer() + "/" + pointer_token(key),
                               "missing",
                               "the key \"" + std::string(key) + "\" is required here",
                               {},
                               {}});
    }
    return member;
}

double JsonReader::number(std::string_view key, const Interval& allowed, double fallback) {
    const auto member = find(key);
    return member ? member->number(allowed).value_or(fallback) : fallback;
}

std::optional<double> JsonReader::require_number(std::string_view key, const Interval& allowed) {
    const auto member = require(key);
    return member ? member->number(allowed) : std::nullopt;
}

std::int64_t JsonReader::integer(std::string_view key, std::int64_t low, std::int64_t high,
                                 std::int64_t fallback, bool is_limit) {
    const auto member = find(key);
    return member ? member->integer(low, high, is_limit).value_or(fallback) : fallback;
}

bool JsonReader::boolean(std::string_view key, bool fallback) {
    const auto member = find(key);
    return member ? member->boolean().value_or(fallback) : fallback;
}

std::optional<std::string> JsonReader::require_text(std::string_view key, std::size_t max_bytes) {
    const auto member = require(key);
    return member ? member->text(max_bytes) : std::nullopt;
}

std::optional<renderer::Vec3> JsonReader::require_vec3(std::string_view key) {
    const auto member = require(key);
    return member ? member->vec3() : std::nullopt;
}

std::string_view JsonReader::one_of(std::string_view key,
                                    const std::vector<std::string_view>& words,
                                    std::string_view fallback) {
    const auto member = find(key);
    return member ? member->one_of(words).value_or(fallback) : fallback;
}

void JsonReader::reject_unknown_keys() const {
    if (!is_object()) return;
    for (const auto& [key, member] : value_.json().members()) {
        if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
        Problems& problems = value_.problems();
        if (problems.is_full()) {
            problems.add({});
            continue;
        }
        problems.add({value_.pointer() + "/" + pointer_token(key), "unknown-key",
                      "this key is not known here." + did_you_mean(key, known_), describe(member),
                      "the keys " + quoted_list(known_)});
    }
}

void report_unknown_type(const JsonValue& type, const std::vector<std::string_view>& names) {
    const std::string_view name = type.json().text();
    type.report("unknown-type", "there is no such type." + did_you_mean(name, names),
                "one of " + quoted_list(names));
}

}  // namespace bouguer::api
