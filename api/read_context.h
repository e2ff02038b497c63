// SPDX-License-Identifier: Apache-2.0
// What the readers of a document share.
#pragma once

#include "api/document_assets.h"
#include "api/limits.h"

namespace bouguer::api {

struct ReadContext {
    const Limits& limits;
    DocumentAssets& assets;
};

}  // namespace bouguer::api
