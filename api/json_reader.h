// SPDX-License-Identifier: Apache-2.0
// Reads one object of the document: collects every problem, stops at none.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "api/json_value.h"

namespace bouguer::api {

/// Hands out the members of an object and remembers which keys were asked for, so that the others
/// can be reported. A value that is no object is reported once and then looks empty. Keys are
/// string literals. Getters with a fallback return it for an absent member and after a report.
class JsonReader {
  public:
    explicit JsonReader(JsonValue value);

    [[nodiscard]] bool is_object() const { return value_.json().is_object(); }
    [[nodiscard]] const JsonValue& value() const { return value_; }

    /// The member, when there is one.
    [[nodiscard]] std::optional<JsonValue> find(std::string_view key);
    /// The member; its absence is reported as "missing", pointing to where it should be.
    [[nodiscard]] std::optional<JsonValue> require(std::string_view key);

    [[nodiscard]] double number(std::string_view key, const Interval& allowed, double fallback);
    [[nodiscard]] std::optional<double> require_number(std::string_view key,
                                                       const Interval& allowed);
    [[nodiscard]] std::int64_t integer(std::string_view key, std::int64_t low, std::int64_t high,
                                       std::int64_t fallback, bool is_limit = false);
    [[nodiscard]] bool boolean(std::string_view key, bool fallback);
    [[nodiscard]] std::optional<std::string> require_text(std::string_view key,
                                                          std::size_t max_bytes);
    [[nodiscard]] std::optional<renderer::Vec3> require_vec3(std::string_view key);
    [[nodiscard]] std::string_view one_of(std::string_view key,
                                          const std::vector<std::string_view>& words,
                                          std::string_view fallback);

    /// Reports every key that was not asked for, with the nearest that was. Call it last.
    void reject_unknown_keys() const;

  private:
    JsonValue value_;
    std::vector<std::string_view> known_;
};

/// Reports that `type` is none of `names`.
void report_unknown_type(const JsonValue& type, const std::vector<std::string_view>& names);

/// The entry of a registry table (anything with a `name`) that the object's `type` names. Null
/// after a report: "missing", "wrong-type" or "unknown-type"; then nothing else of the object can
/// be judged.
template <class Table>
[[nodiscard]] const typename Table::value_type* find_type(JsonReader& reader, const Table& table) {
    if (!reader.is_object()) return nullptr;
    const auto type = reader.require("type");
    if (!type) return nullptr;
    if (!type->json().is_string()) {
        type->report_type("a string");
        return nullptr;
    }
    const std::string_view name = type->json().text();
    std::vector<std::string_view> names;
    for (const auto& entry : table) {
        if (entry.name == name) return &entry;
        names.push_back(entry.name);
    }
    report_unknown_type(*type, names);
    return nullptr;
}

}  // namespace bouguer::api
