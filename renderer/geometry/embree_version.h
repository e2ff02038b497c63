// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace bouguer::renderer {

/// "Embree 3.13.5": what this was compiled with.
[[nodiscard]] std::string embree_version();

}  // namespace bouguer::renderer
