// SPDX-License-Identifier: Apache-2.0
#include "api/error_curve.h"

#include <cmath>
#include <cstdint>

#include "api/json_parser.h"
#include "api/limits.h"

namespace bouguer::api {
namespace {

double number_at(const Json& object, std::string_view key) {
    const auto value = object.find(key);
    return value && value->is_number() ? value->number() : 0;
}

std::optional<renderer::Estimate> estimate_at(const Json& object, std::string_view key) {
    const auto value = object.find(key);
    if (!value || !value->is_object()) return std::nullopt;
    return renderer::Estimate{number_at(*value, "value"), number_at(*value, "low"),
                              number_at(*value, "high")};
}

renderer::ErrorPoint read_point(const Json& object) {
    const auto few_events = object.find("few_events");
    return {number_at(object, "seconds"),
            static_cast<std::uint32_t>(number_at(object, "samples")),
            static_cast<std::uint64_t>(number_at(object, "rays")),
            estimate_at(object, "rmse"),
            estimate_at(object, "relative_rmse"),
            few_events && few_events->is_boolean() && few_events->boolean()};
}

}  // namespace

std::optional<double> error_slope(const std::vector<renderer::ErrorPoint>& curve) {
    double n = 0;
    double sum_x = 0;
    double sum_y = 0;
    double sum_xx = 0;
    double sum_xy = 0;
    for (const renderer::ErrorPoint& point : curve) {
        if (!point.rmse || !(point.rmse->value > 0) || !std::isfinite(point.rmse->value)) continue;
        if (point.samples == 0) continue;
        const double x = std::log(static_cast<double>(point.samples));
        const double y = std::log(point.rmse->value);
        n += 1;
        sum_x += x;
        sum_y += y;
        sum_xx += x * x;
        sum_xy += x * y;
    }
    const double spread = n * sum_xx - sum_x * sum_x;
    if (n < 3 || !(spread > 1e-9)) return std::nullopt;
    return (n * sum_xy - sum_x * sum_y) / spread;
}

Result<std::vector<renderer::ErrorPoint>> read_error_curve(std::string_view json) {
    Limits limits;  // of documents of clients: none holds for a text of our own
    limits.body_bytes = limits.name_bytes = SIZE_MAX;
    const auto tree = read_json_tree(json, limits);
    const auto points = tree ? tree->root().find("points") : std::nullopt;
    if (!points || !points->is_array()) {
        return fail(ErrorKind::Internal, "the stored error curve is damaged", "result-damaged");
    }
    std::vector<renderer::ErrorPoint> curve;
    for (std::size_t i = 0; i < points->size(); ++i) curve.push_back(read_point((*points)[i]));
    return curve;
}

}  // namespace bouguer::api
