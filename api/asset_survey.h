// SPDX-License-Identifier: Apache-2.0
// Which files a scene names, found before anything of it is read.
#pragma once

#include "api/json_tree.h"
#include "api/read_context.h"

namespace bouguer::api {

/// Tells `context.assets` to expect every file that the readers of `scene` will ask for: of image
/// textures and of objects of type "file". Reports nothing: what is wrong with the document the
/// readers find.
void survey_assets(const Json& scene, const ReadContext& context);

}  // namespace bouguer::api
