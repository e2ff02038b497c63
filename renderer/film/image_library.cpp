// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/image_library.h"

#include <OpenImageIO/imageio.h>

namespace bouguer::renderer {

void set_up_image_library() {
    [[maybe_unused]] static const bool done =
        OIIO::attribute("threads", 1) && OIIO::attribute("exr_threads", -1);
}

std::string image_library_version() {
    const int v = OIIO::openimageio_version();  // 20407 is 2.4.7
    return "OpenImageIO " + std::to_string(v / 10000) + "." + std::to_string(v / 100 % 100) + "." +
           std::to_string(v % 100);
}

}  // namespace bouguer::renderer
