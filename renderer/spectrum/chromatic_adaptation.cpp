// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/chromatic_adaptation.h"

namespace bouguer::renderer {
namespace {

constexpr Matrix3 kIdentity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

constexpr Matrix3 kBradford{
    {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};

constexpr Matrix3 kCat16{{{0.401288, 0.650173, -0.051461},
                          {-0.250268, 1.204414, 0.045854},
                          {-0.002079, 0.048952, 0.953127}}};

std::array<double, 3> at_unit_luminance(Chromaticity c) {
    return {c.x / c.y, 1, (1 - c.x - c.y) / c.y};
}

}  // namespace

Matrix3 adaptation_matrix(Adaptation method, Chromaticity from, Chromaticity to) {
    if (method == Adaptation::None) return kIdentity;
    const Matrix3& to_cones = method == Adaptation::Bradford ? kBradford : kCat16;
    const auto cones_from = to_cones * at_unit_luminance(from);
    const auto cones_to = to_cones * at_unit_luminance(to);
    Matrix3 scale{};
    for (std::size_t i = 0; i < 3; ++i) scale[i][i] = cones_to[i] / cones_from[i];
    return inverse(to_cones) * scale * to_cones;
}

}  // namespace bouguer::renderer
