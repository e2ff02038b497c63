// SPDX-License-Identifier: Apache-2.0
// The ambient term of a scene (equation 2).
//
//     { "k_a": 0.3, "weights": "hemisphere", "rays": 1, "illuminant": <spectrum> }
//     { "k_a": 0.3, "weights": { "<object>": k, ... } }           objects not named weigh 0
#pragma once

#include <optional>

#include "api/json_value.h"
#include "api/object_reader.h"
#include "api/spectrum_reader.h"
#include "renderer/scene/description.h"

namespace bouguer::api {

/// The ambient term at `value`; `objects` are the scene's. Empty after a report.
[[nodiscard]] std::optional<renderer::AmbientDescription> read_ambient(const JsonValue& value,
                                                                       const NameIndex& objects,
                                                                       SpectrumReader& spectra);

}  // namespace bouguer::api
