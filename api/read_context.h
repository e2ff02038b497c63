// SPDX-License-Identifier: Apache-2.0
// What the readers of a document share.
#pragma once

#include "api/job_document.h"
#include "api/limits.h"

namespace bouguer::api {

struct ReadContext {
    const Limits& limits;
    const AssetSource& assets;
};

}  // namespace bouguer::api
