// SPDX-License-Identifier: Apache-2.0
#include "api/json_value.h"

#include <array>
#include <charconv>
#include <cmath>

#include "api/json_text.h"
#include "api/nearest_name.h"

namespace bouguer::api {
namespace {

constexpr std::string_view code_for(double x, const Interval& allowed) {
    return allowed.is_limit && x > allowed.high ? "over-limit" : "out-of-range";
}

/// The value of an integral number; empty when it has a fraction or does not fit.
std::optional<std::int64_t> integral(const Json& json) {
    constexpr double kExact = 9007199254740992;  // 2^53: beyond, doubles are not every integer
    if (json.is_whole()) return json.integer();
    const double x = json.number();
    if (std::abs(x) > kExact || std::trunc(x) != x) return std::nullopt;
    return static_cast<std::int64_t>(x);
}

}  // namespace

std::string number_text(double x) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x);
    return {buffer.data(), end.ptr};
}

bool Interval::contains(double x) const {
    return (is_low_open ? x > low : x >= low) && (is_high_open ? x < high : x <= high);
}

std::string Interval::text() const {
    std::string text(is_low_open ? "(" : "[");
    text += number_text(low) + ", " + number_text(high);
    text += is_high_open ? ')' : ']';
    return text;
}

void JsonValue::report(std::string_view code, std::string detail, std::string allowed) const {
    problems_->add(
        {pointer_, std::string(code), std::move(detail), describe(json_), std::move(allowed)});
}

void JsonValue::warn(std::string_view code, std::string detail, std::string advice) const {
    problems_->warn({pointer_, std::string(code), std::move(detail), std::move(advice)});
}

void JsonValue::report_type(std::string allowed) const {
    report("wrong-type", "the value must be " + allowed, allowed);
}

JsonValue JsonValue::member(std::string_view key) const {
    return {json_.find(key).value(), pointer_ + "/" + pointer_token(key), *problems_};
}

JsonValue JsonValue::element(std::size_t index) const {
    return {json_[index], pointer_ + "/" + std::to_string(index), *problems_};
}

bool JsonValue::is_array(std::size_t min, std::size_t max, std::string_view of) const {
    const std::string name(of);
    if (!json_.is_array()) {
        report_type("an array of " + name);
        return false;
    }
    const std::size_t size = json_.size();
    if (size >= min && size <= max) return true;
    const bool is_short = size < min;
    report(is_short ? "too-few" : "over-limit",
           "the array has too " + std::string(is_short ? "few " : "many ") + name,
           std::to_string(min) + " to " + std::to_string(max) + " " + name);
    return false;
}

bool JsonValue::is_tuple(std::size_t size, std::string_view of) const {
    const std::string allowed = "an array of " + std::to_string(size) + " " + std::string(of);
    if (!json_.is_array()) {
        report_type(allowed);
        return false;
    }
    if (json_.size() == size) return true;
    report("wrong-count", "the array has the wrong length", allowed);
    return false;
}

std::optional<double> JsonValue::number(const Interval& allowed) const {
    if (!json_.is_number()) {
        report_type("a number in " + allowed.text());
        return std::nullopt;
    }
    const auto x = json_.number();
    if (allowed.contains(x)) return x;
    const std::string text = "a number in " + allowed.text();
    report(code_for(x, allowed), "the value must be " + text, text);
    return std::nullopt;
}

std::optional<std::int64_t> JsonValue::integer(std::int64_t low, std::int64_t high,
                                               bool is_limit) const {
    const std::string text =
        "an integer in [" + std::to_string(low) + ", " + std::to_string(high) + "]";
    if (!json_.is_number()) {
        report_type(text);
        return std::nullopt;
    }
    const auto approximate = json_.number();
    if (std::trunc(approximate) != approximate) {
        report_type(text);
        return std::nullopt;
    }
    const auto x = integral(json_);
    if (x && *x >= low && *x <= high) return x;
    report(is_limit && approximate > static_cast<double>(high) ? "over-limit" : "out-of-range",
           "the value must be " + text, text);
    return std::nullopt;
}

std::optional<bool> JsonValue::boolean() const {
    if (json_.is_boolean()) return json_.boolean();
    report_type("true or false");
    return std::nullopt;
}

std::optional<std::string> JsonValue::text(std::size_t max_bytes) const {
    const std::string allowed = "a string of 1 to " + std::to_string(max_bytes) + " bytes";
    if (!json_.is_string()) {
        report_type(allowed);
        return std::nullopt;
    }
    const std::string_view text = json_.text();
    if (!text.empty() && text.size() <= max_bytes) return std::string(text);
    report(text.empty() ? "out-of-range" : "over-limit", "the value must be " + allowed, allowed);
    return std::nullopt;
}

std::optional<renderer::Vec3> JsonValue::vec3(const Interval& each) const {
    if (!is_tuple(3, "numbers")) return std::nullopt;
    const auto x = element(0).number(each);
    const auto y = element(1).number(each);
    const auto z = element(2).number(each);
    if (!x || !y || !z) return std::nullopt;
    return renderer::Vec3{*x, *y, *z};
}

std::optional<renderer::Vec3> JsonValue::direction() const {
    const auto v = vec3();
    if (!v) return std::nullopt;
    const double size = renderer::max_abs(*v);
    if (size > 0) return *v / size;  // so that no length over- or underflows
    report("degenerate", "a direction must have a length", "three numbers, not all 0");
    return std::nullopt;
}

std::optional<std::vector<double>> JsonValue::numbers(std::size_t max) const {
    if (!is_array(0, max, "numbers")) return std::nullopt;
    const auto packed = json_.packed_numbers();
    std::vector<double> values(packed.begin(), packed.end());
    if (values.size() == json_.size()) return values;
    values.reserve(json_.size());
    for (std::size_t i = 0; i < json_.size(); ++i) {
        const Json value = json_[i];
        if (value.is_number()) {
            values.push_back(value.number());
        } else {
            element(i).report_type("a number");
        }
    }
    if (values.size() < json_.size()) return std::nullopt;
    return values;
}

std::optional<std::string_view> JsonValue::one_of(
    const std::vector<std::string_view>& words) const {
    const std::string allowed = "one of " + quoted_list(words);
    if (!json_.is_string()) {
        report_type(allowed);
        return std::nullopt;
    }
    const std::string_view text = json_.text();
    for (const std::string_view word : words) {
        if (word == text) return word;
    }
    report("unknown-name", "this word is not known here." + did_you_mean(text, words), allowed);
    return std::nullopt;
}

}  // namespace bouguer::api
