// SPDX-License-Identifier: Apache-2.0
// /v1/library: what documents may name without defining it.
#pragma once

#include "server/http/router.h"

namespace bouguer::server {

/// The whole library, its parts, and each thing that is a function of wavelength: with its values,
/// and as a plot.
void add_library_routes(Router& router);

}  // namespace bouguer::server
