// SPDX-License-Identifier: Apache-2.0
// Materials that nothing uses, or that give back more light than they get.
#pragma once

#include "api/warning_sink.h"
#include "renderer/scene/description.h"

namespace bouguer::api {

void warn_of_materials(const renderer::SceneDescription& scene, WarningSink& sink);

}  // namespace bouguer::api
