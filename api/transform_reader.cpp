// SPDX-License-Identifier: Apache-2.0
#include "api/transform_reader.h"

#include <array>
#include <string_view>

#include "api/json_reader.h"
#include "api/nearest_name.h"

namespace bouguer::api {
namespace {

using renderer::Transform;
using renderer::Vec3;

constexpr Interval kAngle_deg{-1e6, 1e6};

std::optional<Transform> read_translate(const JsonValue& value) {
    const auto by = value.vec3();
    return by ? std::optional(Transform::translate(*by)) : std::nullopt;
}

std::optional<Transform> read_rotate(const JsonValue& value) {
    JsonReader reader(value);
    const auto at = reader.require("axis");
    const auto axis = at ? at->direction() : std::nullopt;
    const auto angle_deg = reader.require_number("angle_deg", kAngle_deg);
    reader.reject_unknown_keys();
    if (!axis || !angle_deg) return std::nullopt;
    return Transform::rotate(*axis, renderer::degrees_to_radians(*angle_deg));
}

std::optional<Transform> read_scale(const JsonValue& value) {
    if (!value.json().is_number()) {
        const auto by = value.vec3();
        return by ? std::optional(Transform::scale(*by)) : std::nullopt;
    }
    const auto by = value.number(kCoordinate);
    return by ? std::optional(Transform::scale({*by, *by, *by})) : std::nullopt;
}

/// The last row of a 4 x 4 matrix, which must be that of an affine map.
bool is_affine_row(const JsonValue& row) {
    if (!row.is_tuple(4, "numbers")) return false;
    for (std::size_t i = 0; i < 4; ++i) {
        const double wanted = i == 3 ? 1 : 0;
        if (!row.element(i).number({wanted, wanted})) return false;
    }
    return true;
}

std::optional<Transform> read_matrix(const JsonValue& value) {
    const bool has_four_rows = value.json().is_array() && value.json().size() == 4;
    if (!has_four_rows && !value.is_tuple(3, "or 4 rows of 4 numbers")) return std::nullopt;
    Transform m;
    bool is_good = true;
    for (std::size_t row = 0; row < 3; ++row) {
        const JsonValue at = value.element(row);
        std::array<double, 4> numbers{};
        if (!at.is_tuple(4, "numbers")) {
            is_good = false;
            continue;
        }
        for (std::size_t i = 0; i < 4; ++i) {
            const auto number = at.element(i).number(kCoordinate);
            is_good = is_good && number;
            numbers[i] = number.value_or(0);
        }
        m.a[row] = {numbers[0], numbers[1], numbers[2]};
        (row == 0 ? m.t.x : row == 1 ? m.t.y : m.t.z) = numbers[3];
    }
    if (has_four_rows && !is_affine_row(value.element(3))) is_good = false;
    return is_good ? std::optional(m) : std::nullopt;
}

struct StepKind {
    std::string_view key;
    std::optional<Transform> (*read)(const JsonValue&);
};

/// To add a kind of step, write its function and its line here.
constexpr std::array kSteps{
    StepKind{"translate", &read_translate},
    StepKind{"rotate", &read_rotate},
    StepKind{"scale", &read_scale},
    StepKind{"matrix", &read_matrix},
};

/// `m`, when it can be inverted.
std::optional<Transform> invertible(const JsonValue& value, const Transform& m) {
    if (m.inverse()) return m;
    value.report("singular", "the transform cannot be inverted: it flattens or overflows",
                 "a transform with an inverse");
    return std::nullopt;
}

/// An object with exactly one key, the kind of the step.
std::optional<Transform> read_step(const JsonValue& value) {
    JsonReader reader(value);
    if (!reader.is_object()) return std::nullopt;
    std::vector<std::string_view> keys;
    for (const StepKind& kind : kSteps) {
        keys.push_back(kind.key);
        if (!value.json().contains(kind.key)) continue;
        const auto step = kind.read(*reader.find(kind.key));
        reader.reject_unknown_keys();
        return step ? invertible(value, *step) : std::nullopt;
    }
    std::string hint;
    if (value.json().size() > 0) {
        hint = did_you_mean((*value.json().members().begin()).key, keys);
    }
    value.report("unknown-type", "no key of this object tells the kind of step." + hint,
                 "an object with one of the keys " + quoted_list(keys));
    return std::nullopt;
}

std::optional<Transform> read_steps(const JsonValue& value, const Limits& limits) {
    if (!value.is_array(0, limits.transform_steps, "steps")) return std::nullopt;
    Transform all;
    bool is_good = true;
    for (std::size_t i = 0; i < value.json().size(); ++i) {
        const auto step = read_step(value.element(i));
        is_good = is_good && step;
        if (step) all = *step * all;
    }
    return is_good ? invertible(value, all) : std::nullopt;
}

}  // namespace

std::optional<Transform> read_transform(const JsonValue& value, const Limits& limits) {
    if (value.json().is_array()) return read_steps(value, limits);
    if (!value.json().is_object()) {
        value.report_type("an object with \"matrix\", or an array of steps");
        return std::nullopt;
    }
    JsonReader reader(value);
    const auto matrix = reader.require("matrix");
    const auto m = matrix ? read_matrix(*matrix) : std::nullopt;
    reader.reject_unknown_keys();
    return m ? invertible(value, *m) : std::nullopt;
}

}  // namespace bouguer::api
