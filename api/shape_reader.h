// SPDX-License-Identifier: Apache-2.0
// Shapes of a document, by the registry of shape_reader.cpp; meshes are in mesh_reader.h.
#pragma once

#include <optional>

#include "api/json_value.h"
#include "api/read_context.h"
#include "renderer/geometry/shape.h"

namespace bouguer::api {

/// The shape at `value`. Empty after a report.
[[nodiscard]] std::optional<renderer::Shape> read_shape(const JsonValue& value,
                                                        const ReadContext& context);

}  // namespace bouguer::api
