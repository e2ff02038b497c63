// SPDX-License-Identifier: Apache-2.0
// The web page at / and the documentation at /docs, both inside the binary.
#pragma once

#include "server/http/router.h"

namespace bouguer::server {

void add_web_routes(Router& router);

}  // namespace bouguer::server
