// SPDX-License-Identifier: Apache-2.0
// The description of the service, compiled in.
#pragma once

#include <string_view>

namespace bouguer::api {

/// OpenAPI 3.1 as JSON, with the schemas of scene and job among its components: what
/// GET /v1/openapi.json gives.
[[nodiscard]] std::string_view openapi_json();

}  // namespace bouguer::api
