// SPDX-License-Identifier: Apache-2.0
// The web page at /, the documentation at /docs and the OpenAPI description, all inside the binary.
#pragma once

#include "server/http/router.h"

namespace bouguer::server {

void add_web_routes(Router& router);

}  // namespace bouguer::server
