// SPDX-License-Identifier: Apache-2.0
#include "api/json_builder.h"

#include <cmath>

#include "api/json_value.h"

namespace bouguer::api {

std::string json_number(double x) { return std::isfinite(x) ? number_text(x) : "null"; }

JsonObject& JsonObject::set_json(std::string_view key, std::string_view json) {
    if (!members_.empty()) members_ += ',';
    members_ += json_string(key);
    members_ += ':';
    members_ += json;
    return *this;
}

JsonArray& JsonArray::add_json(std::string_view json) {
    if (!elements_.empty()) elements_ += ',';
    elements_ += json;
    return *this;
}

}  // namespace bouguer::api
