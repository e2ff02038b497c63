// SPDX-License-Identifier: Apache-2.0
// How a picture is seen: through exposure and adaptation, on a display.
#pragma once

#include "renderer/core/result.h"
#include "renderer/render.h"
#include "renderer/spectrum/display.h"

namespace bouguer::renderer {

/// What `output` makes of a picture before it meets the limits of the display. The display's white
/// has Y = 1.
struct View {
    const Display* display = nullptr;  ///< lives as long as the program
    double exposure = 1;
    Matrix3 from_film{};  ///< XYZ of the film -> XYZ as seen: exposed, then adapted

    [[nodiscard]] Xyz operator()(const float* xyz) const {
        const auto [x, y, z] = from_film * std::array<double, 3>{xyz[0], xyz[1], xyz[2]};
        return {x, y, z};
    }
};

/// `picture` gives the exposure where `output` does not. Error{InvalidInput}: no such display, or
/// an adaptation without a white, or from one that cannot be a white.
[[nodiscard]] Result<View> view_of(const Picture& picture, const OutputSettings& output);

}  // namespace bouguer::renderer
