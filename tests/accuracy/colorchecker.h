// SPDX-License-Identifier: Apache-2.0
// The ColorChecker as the renderer shows it, beside the same colours without a ray.
#pragma once

#include <string>
#include <vector>

#include "renderer/spectrum/colour_difference.h"

namespace bouguer::test {

/// L*a*b* relative to the illuminant's own white at 1 nm, 2-degree observer.
struct PatchColour {
    std::string name;        ///< "dark-skin" ...
    renderer::Lab rendered;  ///< scene document -> render -> film
    renderer::Lab direct;    ///< reflectance x illuminant x colour-matching functions at 1 nm
    [[nodiscard]] double delta_e() const { return renderer::delta_e_2000(rendered, direct); }
};

/// The 24 patches of client-examples/scenes/colour/colorchecker-<illuminant>.json in the chart's
/// order, rendered at `step_nm`.
[[nodiscard]] std::vector<PatchColour> render_colorchecker(const std::string& illuminant,
                                                           double step_nm);

/// The largest CIEDE2000 of rendered and direct.
[[nodiscard]] double worst_delta_e(const std::vector<PatchColour>& patches);

/// A published chart: what its maker or measurer says that the patches look like under D50.
struct PublishedChart {
    std::string name;
    std::vector<renderer::Lab> patches;  ///< in the chart's order, relative to D50
};

/// The charts of tests/accuracy/data/colorchecker_published.csv.
[[nodiscard]] std::vector<PublishedChart> published_charts();

}  // namespace bouguer::test
