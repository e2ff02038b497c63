// SPDX-License-Identifier: Apache-2.0
// Meshes that light goes through, made fit for it.
#pragma once

#include "renderer/scene/description.h"

namespace bouguer::renderer {

/// Puts mended_mesh() in the place of every mesh whose object's material transmits; each mesh is
/// looked at once, however many objects have it. Does nothing to what was mended before.
void mend_meshes(SceneDescription& scene);

}  // namespace bouguer::renderer
