// SPDX-License-Identifier: Apache-2.0
// Transforms of a document: { "matrix": [[a, b, c, x], ...] }, three or four rows, or a list of
// steps that are applied in the order written:
//
//     { "translate": [x, y, z] } | { "rotate": { "axis": [x, y, z], "angle_deg": 30 } }
//     | { "scale": s } | { "scale": [x, y, z] } | { "matrix": ... }
#pragma once

#include <optional>

#include "api/json_value.h"
#include "api/limits.h"
#include "renderer/core/transform.h"

namespace bouguer::api {

/// The transform at `value`; it can be inverted. Empty after a report ("singular", "degenerate"
/// ...).
[[nodiscard]] std::optional<renderer::Transform> read_transform(const JsonValue& value,
                                                                const Limits& limits);

}  // namespace bouguer::api
