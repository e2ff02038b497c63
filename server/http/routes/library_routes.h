// SPDX-License-Identifier: Apache-2.0
// /v1/library: what documents may name without defining it.
#pragma once

#include "server/http/router.h"

namespace bouguer::server {

/// The whole library, its parts, and each spectrum with its values at 5 nm.
void add_library_routes(Router& router);

}  // namespace bouguer::server
