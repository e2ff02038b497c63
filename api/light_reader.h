// SPDX-License-Identifier: Apache-2.0
// Lights of a document, by the registry of light_reader.cpp, and the environment.
#pragma once

#include <optional>

#include "api/json_value.h"
#include "api/spectrum_reader.h"
#include "renderer/scene/description.h"

namespace bouguer::api {

/// The light at `value`. Empty after a report.
[[nodiscard]] std::optional<renderer::LightDescription> read_light(const JsonValue& value,
                                                                   SpectrumReader& spectra);

/// The environment at `value`. Empty after a report.
[[nodiscard]] std::optional<renderer::ConstantEnvironment> read_environment(
    const JsonValue& value, SpectrumReader& spectra);

}  // namespace bouguer::api
