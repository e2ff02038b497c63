// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/view.h"

#include "renderer/film/image_file.h"

namespace bouguer::renderer {
namespace {

Result<Matrix3> adaptation_of(const OutputSettings& output, const Display& display) {
    const auto white = output.adapted_white().value_or(Chromaticity{});
    if (output.adaptation != Adaptation::None && !can_be_white(output.adaptation, white))
        return fail(ErrorKind::InvalidInput, "adaptation needs the white of the scene's light");
    return adaptation_matrix(output.adaptation, white, display.chromaticities[3]);
}

}  // namespace

Result<View> view_of(const Picture& picture, const OutputSettings& output) {
    const Display* display = find_display(output.display);
    if (!display)
        return fail(ErrorKind::InvalidInput, "there is no display \"" + output.display + "\"");
    const auto adaptation = adaptation_of(output, *display);
    if (!adaptation) return tl::unexpected(adaptation.error());
    View view{display, output.exposure ? *output.exposure : automatic_exposure(picture),
              *adaptation};
    for (auto& row : view.from_film)
        for (double& v : row) v *= view.exposure;
    return view;
}

}  // namespace bouguer::renderer
