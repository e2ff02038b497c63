// SPDX-License-Identifier: Apache-2.0
// Writes small JSON texts for code that must not know a JSON library: what the server says of its
// jobs.
//
//     JsonObject().set("id", id).set("samples", 16).set_json("plan", plan_json(plan)).text()
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "api/json_string.h"

namespace bouguer::api {

/// `x` as short as it round-trips; "null" when it is not finite.
[[nodiscard]] std::string json_number(double x);

/// An object whose members stand in the order in which they were set. Every key is set once.
class JsonObject {
  public:
    JsonObject& set(std::string_view key, std::string_view text) {
        return set_json(key, json_string(text));
    }
    JsonObject& set(std::string_view key, const char* text) {
        return set(key, std::string_view(text));
    }
    JsonObject& set(std::string_view key, double x) { return set_json(key, json_number(x)); }
    JsonObject& set(std::string_view key, bool value) {
        return set_json(key, value ? "true" : "false");
    }
    template <std::integral T>
    JsonObject& set(std::string_view key, T value) {
        return set_json(key, std::to_string(value));
    }
    /// null when there is nothing.
    template <class T>
    JsonObject& set(std::string_view key, const std::optional<T>& value) {
        return value ? set(key, *value) : set_json(key, "null");
    }
    /// `json` is JSON already.
    JsonObject& set_json(std::string_view key, std::string_view json);

    [[nodiscard]] std::string text() const { return "{" + members_ + "}"; }

  private:
    std::string members_;
};

/// An array, in the order of addition.
class JsonArray {
  public:
    JsonArray& add(std::string_view text) { return add_json(json_string(text)); }
    /// `json` is JSON already.
    JsonArray& add_json(std::string_view json);

    [[nodiscard]] std::string text() const { return "[" + elements_ + "]"; }

  private:
    std::string elements_;
};

}  // namespace bouguer::api
