// SPDX-License-Identifier: Apache-2.0
// Spectra that the wavelengths of a render are too few for.
#pragma once

#include "api/warning_sink.h"
#include "renderer/scene/description.h"
#include "renderer/settings.h"

namespace bouguer::api {

/// Warns of materials whose colour is narrow where a light's is, too: between two nodes their means
/// are multiplied, which is not the mean of their product.
void warn_of_narrow_spectra(const renderer::SceneDescription& scene,
                            const renderer::RenderSettings& settings, WarningSink& sink);

}  // namespace bouguer::api
