// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/chromatic_adaptation.h"

#include <algorithm>

namespace bouguer::renderer {
namespace {

constexpr Matrix3 kIdentity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

constexpr Matrix3 kBradford{
    {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};

constexpr Matrix3 kCat16{{{0.401288, 0.650173, -0.051461},
                          {-0.250268, 1.204414, 0.045854},
                          {-0.002079, 0.048952, 0.953127}}};

/// Below this the luminance of a white would be lost in its colour.
constexpr double kLeastY = 1e-3;

const Matrix3& to_cones_of(Adaptation method) {
    return method == Adaptation::Bradford ? kBradford : kCat16;
}

/// Responses of the cones to the colour at Y = 1.
std::array<double, 3> cones_of(Adaptation method, Chromaticity c) {
    return to_cones_of(method) * std::array{c.x / c.y, 1.0, (1 - c.x - c.y) / c.y};
}

}  // namespace

Matrix3 adaptation_matrix(Adaptation method, Chromaticity from, Chromaticity to) {
    if (method == Adaptation::None) return kIdentity;
    const Matrix3& to_cones = to_cones_of(method);
    const auto cones_from = cones_of(method, from);
    const auto cones_to = cones_of(method, to);
    Matrix3 scale{};
    for (std::size_t i = 0; i < 3; ++i) scale[i][i] = cones_to[i] / cones_from[i];
    return inverse(to_cones) * scale * to_cones;
}

bool can_be_white(Adaptation method, Chromaticity c) {
    if (!(c.y >= kLeastY)) return false;
    if (method == Adaptation::None) return true;
    const auto cones = cones_of(method, c);
    return std::all_of(cones.begin(), cones.end(), [](double response) { return response > 0; });
}

}  // namespace bouguer::renderer
