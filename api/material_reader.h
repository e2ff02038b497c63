// SPDX-License-Identifier: Apache-2.0
// Materials of a document, by the registry of material_reader.cpp.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "api/json_value.h"
#include "api/spectrum_reader.h"
#include "api/texture_reader.h"
#include "renderer/scene/description.h"

namespace bouguer::api {

/// Where the colours of materials come from.
struct ColourReaders {
    SpectrumReader& spectra;
    TextureReader& textures;
};

/// The material at `value`, without its name. Empty after a report.
[[nodiscard]] std::optional<renderer::MaterialDescription> read_material(
    const JsonValue& value, const ColourReaders& colours);

/// The member `priority` of a material or an object, in [-1000, 1000]: which of several bodies
/// counts where they overlap. Empty when there is none.
[[nodiscard]] std::optional<int> read_priority(JsonReader& reader);

struct MaterialType {
    std::string_view name, description;
};
/// What `type` of a material may be.
[[nodiscard]] const std::vector<MaterialType>& material_types();

}  // namespace bouguer::api
