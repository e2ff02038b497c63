// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/picture_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/film/view.h"
#include "renderer/spectrum/colour_difference.h"

namespace bouguer::renderer {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

Xyz white_of(const Display& display) {
    const Chromaticity c = display.chromaticities[3];
    return {c.x / c.y, 1, (1 - c.x - c.y) / c.y};
}

std::string size_text(const Picture& picture) {
    return std::to_string(picture.width) + " x " + std::to_string(picture.height);
}

/// Of a picture that is as shown already.
View unchanged(const View& view) {
    return {view.display, 1, adaptation_matrix(Adaptation::None, {}, {})};
}

void summarise(PictureDifference& d) {
    std::vector<float> known;
    double sum = 0;
    d.maximum = -1;
    for (std::size_t i = 0; i < d.delta_e.size(); ++i) {
        const float value = d.delta_e[i];
        if (std::isnan(value)) continue;
        known.push_back(value);
        sum += value;
        if (value <= d.maximum) continue;
        d.maximum = value;
        d.maximum_x = static_cast<int>(i % static_cast<std::size_t>(d.width));
        d.maximum_y = static_cast<int>(i / static_cast<std::size_t>(d.width));
    }
    d.compared_pixels = known.size();
    d.unknown_pixels = d.delta_e.size() - known.size();
    if (known.empty()) {
        d.mean = d.percentile_95 = d.maximum = kUnknown;
        return;
    }
    d.mean = sum / static_cast<double>(known.size());
    const auto rank =
        known.begin() + static_cast<std::ptrdiff_t>((known.size() * 95 + 99) / 100 - 1);
    std::nth_element(known.begin(), rank, known.end());
    d.percentile_95 = *rank;
}

}  // namespace

Result<PictureDifference> compare_pictures(const LoadedPicture& loaded_a,
                                           const LoadedPicture& loaded_b,
                                           const OutputSettings& output) {
    const Picture &a = loaded_a.picture, &b = loaded_b.picture;
    if (a.width != b.width || a.height != b.height)
        return fail(ErrorKind::InvalidInput,
                    "the pictures differ in size: " + size_text(a) + " and " + size_text(b),
                    "different-sizes");
    const auto view = view_of(loaded_a.is_as_shown ? b : a, output);
    if (!view) return tl::unexpected(view.error());
    const View view_a = loaded_a.is_as_shown ? unchanged(*view) : *view;
    const View view_b = loaded_b.is_as_shown ? unchanged(*view) : *view;

    PictureDifference difference;
    difference.width = a.width;
    difference.height = a.height;
    difference.exposure = view->exposure;
    difference.delta_e.reserve(a.xyz.size() / 3);
    const Xyz white = white_of(*view->display);
    for (std::size_t i = 0; i < a.xyz.size(); i += 3) {
        const double delta_e =
            delta_e_2000(lab_of(view_a(&a.xyz[i]), white), lab_of(view_b(&b.xyz[i]), white));
        difference.delta_e.push_back(std::isfinite(delta_e) ? static_cast<float>(delta_e)
                                                            : kUnknown);
    }
    summarise(difference);
    return difference;
}

}  // namespace bouguer::renderer
