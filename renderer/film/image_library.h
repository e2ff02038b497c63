// SPDX-License-Identifier: Apache-2.0
// What reading and writing of images share of OpenImageIO.
#pragma once

#include <string>

namespace bouguer::renderer {

/// Every call into OpenImageIO comes after this: it starts no threads of its own, because the
/// callers are a pool of workers already. Thread-safe.
void set_up_image_library();

/// "OpenImageIO 2.4.7": the library at run time.
[[nodiscard]] std::string image_library_version();

}  // namespace bouguer::renderer
