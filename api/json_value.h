// SPDX-License-Identifier: Apache-2.0
// One value of a document with its place: checked getters that report instead of guessing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "api/json_tree.h"
#include "api/problems.h"
#include "renderer/core/vec3.h"

namespace bouguer::api {

/// The numbers that are accepted somewhere.
struct Interval {
    double low, high;
    bool is_low_open = false, is_high_open = false;
    bool is_limit = false;  ///< `high` is a limit of this service: above it is "over-limit"
    [[nodiscard]] bool contains(double x) const;
    [[nodiscard]] std::string text() const;  ///< "[0, 1]", "(0, 180)"
};

/// Lengths and coordinates beyond this are refused, so that nothing overflows on its way to single
/// precision.
inline constexpr double kLargestLength = 1e15;
inline constexpr Interval kPositiveLength{0, kLargestLength, true};
inline constexpr Interval kCoordinate{-kLargestLength, kLargestLength};
inline constexpr Interval kUnit{0, 1};

/// A value, where it stands, and where its problems go. Cheap to copy; the tree and the Problems
/// outlive it. Getters return nothing after they have reported why.
class JsonValue {
  public:
    JsonValue(const Json& json, std::string pointer, Problems& problems)
        : json_(json), pointer_(std::move(pointer)), problems_(&problems) {}

    [[nodiscard]] const Json& json() const { return json_; }
    [[nodiscard]] const std::string& pointer() const { return pointer_; }
    [[nodiscard]] Problems& problems() const { return *problems_; }

    /// Reports a problem of this value.
    void report(std::string_view code, std::string detail, std::string allowed = {}) const;
    /// Warns of this value, which is valid: what is so, and what to do about it.
    void warn(std::string_view code, std::string detail, std::string advice) const;
    /// The type is wrong; `allowed` is what was expected, e.g. "a number".
    void report_type(std::string allowed) const;

    /// A member that exists; `key` is a key of this object.
    [[nodiscard]] JsonValue member(std::string_view key) const;
    [[nodiscard]] JsonValue element(std::size_t index) const;  ///< of an array that is long enough

    /// Whether this is an array with a length in [min, max]; `of` names its elements ("triangles").
    /// Below `min`: "too-few", above `max`: "over-limit".
    [[nodiscard]] bool is_array(std::size_t min, std::size_t max, std::string_view of) const;
    /// Whether this is an array of exactly `size`; another length is "wrong-count".
    [[nodiscard]] bool is_tuple(std::size_t size, std::string_view of) const;

    [[nodiscard]] std::optional<double> number(const Interval& allowed) const;
    /// A number without fractional part; 16 and 16.0 are the same.
    [[nodiscard]] std::optional<std::int64_t> integer(std::int64_t low, std::int64_t high,
                                                      bool is_limit = false) const;
    [[nodiscard]] std::optional<bool> boolean() const;
    /// Of 1 to `max_bytes` bytes.
    [[nodiscard]] std::optional<std::string> text(std::size_t max_bytes) const;
    /// Three coordinates.
    [[nodiscard]] std::optional<renderer::Vec3> vec3(const Interval& each = kCoordinate) const;
    /// Three numbers that are not all zero.
    [[nodiscard]] std::optional<renderer::Vec3> direction() const;
    /// At most `max` numbers of any size.
    [[nodiscard]] std::optional<std::vector<double>> numbers(std::size_t max) const;
    /// One of `words`.
    [[nodiscard]] std::optional<std::string_view> one_of(
        const std::vector<std::string_view>& words) const;

  private:
    Json json_;
    std::string pointer_;
    Problems* problems_;
};

/// A number as text, as short as it round-trips.
[[nodiscard]] std::string number_text(double x);

}  // namespace bouguer::api
