// SPDX-License-Identifier: Apache-2.0
// PUT and GET /v1/assets/{digest}, POST /v1/assets/missing.
#pragma once

#include "server/http/router.h"
#include "server/storage/asset_store.h"

namespace bouguer::server {

/// `assets` outlives the router.
void add_asset_routes(Router& router, AssetStore& assets);

}  // namespace bouguer::server
