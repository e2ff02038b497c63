// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/embree_version.h"

#include "renderer/geometry/embree_api.h"

namespace bouguer::renderer {

std::string embree_version() { return "Embree " RTC_VERSION_STRING; }

}  // namespace bouguer::renderer
