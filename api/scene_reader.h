// SPDX-License-Identifier: Apache-2.0
// A scene document: format, name, units, camera, spectra, textures, materials, objects, lights,
// environment, ambient.
#pragma once

#include "api/json_reader.h"
#include "api/read_context.h"
#include "renderer/scene/description.h"

namespace bouguer::api {

inline constexpr std::string_view kSceneFormat = "bouguer-scene/1";

/// The scene at `value`. After a report the result is incomplete and must not be rendered.
[[nodiscard]] renderer::SceneDescription read_scene(const JsonValue& value,
                                                    const ReadContext& context,
                                                    renderer::SpectrumNotes& notes);

/// Checks the member `format`; an absent one is "missing". False when it names another language
/// ("unknown-format"), in which nothing else can be judged.
[[nodiscard]] bool read_format(JsonReader& reader, std::string_view format);

}  // namespace bouguer::api
