// SPDX-License-Identifier: Apache-2.0
// The camera of a document: perspective or orthographic.
#pragma once

#include <optional>

#include "api/json_value.h"
#include "api/limits.h"
#include "renderer/scene/description.h"

namespace bouguer::api {

struct ReadCamera {
    renderer::CameraDescription camera;
    renderer::Resolution resolution;
};

/// The camera at `value`. Empty after a report.
[[nodiscard]] std::optional<ReadCamera> read_camera(const JsonValue& value, const Limits& limits);

/// [width, height] in pixels, within the limits of a side and of the whole. Empty after a report.
[[nodiscard]] std::optional<renderer::Resolution> read_resolution(const JsonValue& value,
                                                                  const Limits& limits);

}  // namespace bouguer::api
