// SPDX-License-Identifier: Apache-2.0
#include "renderer/samplers/warp.h"

namespace bouguer::renderer {
namespace {

/// A pair of unit normal deviates [Box and Muller 1958], limited to 3 by rescaling u so that the
/// radius never passes it.
Vec2 sample_gaussian_within_3(Vec2 u) {
    constexpr Real kTail = 0.011108996538242306;  // exp(-3^2 / 2)
    const Real r = std::sqrt(-2 * std::log(1 - u.x * (1 - kTail)));
    return {r * std::cos(2 * kPi * u.y), r * std::sin(2 * kPi * u.y)};
}

/// Unit, by the square of the tangent of its angle to +z.
Vec3 direction_of(Real tan2, Real turn) {
    const Real z = 1 / std::sqrt(1 + tan2);
    const Real r = z * std::sqrt(tan2);
    return {r * std::cos(2 * kPi * turn), r * std::sin(2 * kPi * turn), z};
}

}  // namespace

Real sample_tent(Real u) { return u < 0.5 ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 * (1 - u)); }

Vec3 sample_beckmann(Vec2 u, Real m) { return direction_of(-m * m * std::log1p(-u.x), u.y); }

Vec3 sample_trowbridge_reitz(Vec2 u, Real c) { return direction_of(c * c * u.x / (1 - u.x), u.y); }

Vec3 sample_cosine_power(Vec2 u, Real n) {
    const Real z = std::pow(1 - u.x, 1 / (n + 1));
    const Real r = std::sqrt(std::max(Real(0), 1 - z * z));
    return {r * std::cos(2 * kPi * u.y), r * std::sin(2 * kPi * u.y), z};
}

Vec2 sample_filter(const Filter& filter, Vec2 u) {
    switch (filter.type) {
        case FilterType::Box:
            return {filter.radius * (2 * u.x - 1), filter.radius * (2 * u.y - 1)};
        case FilterType::Triangle:
            return {filter.radius * sample_tent(u.x), filter.radius * sample_tent(u.y)};
        case FilterType::Gaussian: {
            const Vec2 g = sample_gaussian_within_3(u);
            return {filter.radius / 3 * g.x, filter.radius / 3 * g.y};
        }
    }
    return {};
}

}  // namespace bouguer::renderer
