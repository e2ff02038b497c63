// SPDX-License-Identifier: Apache-2.0
// Materials of a document, by the registry of material_reader.cpp.
#pragma once

#include <optional>

#include "api/json_value.h"
#include "api/spectrum_reader.h"
#include "renderer/scene/description.h"

namespace bouguer::api {

/// The material at `value`; its spectra come from `spectra`. Empty after a report.
[[nodiscard]] std::optional<renderer::MaterialModel> read_material(const JsonValue& value,
                                                                   SpectrumReader& spectra);

}  // namespace bouguer::api
