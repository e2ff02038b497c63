// SPDX-License-Identifier: Apache-2.0
#include "renderer/core/transform.h"

#include <algorithm>
#include <cmath>

namespace bouguer::renderer {

std::optional<Transform> Transform::inverse() const {
    const Real det = determinant();
    const Real size = length(a[0]) * length(a[1]) * length(a[2]);
    if (!std::isfinite(det) || std::abs(det) <= 1e-12 * size) return std::nullopt;
    // Columns of the inverse are the cross products of the rows, over the determinant.
    const std::array<Vec3, 3> c{cross(a[1], a[2]) / det, cross(a[2], a[0]) / det,
                                cross(a[0], a[1]) / det};
    Transform inv;
    inv.a = {Vec3{c[0].x, c[1].x, c[2].x}, Vec3{c[0].y, c[1].y, c[2].y},
             Vec3{c[0].z, c[1].z, c[2].z}};
    inv.t = -inv.direction(t);
    if (!is_finite(inv.t) || !is_finite(c[0]) || !is_finite(c[1]) || !is_finite(c[2])) {
        return std::nullopt;
    }
    return inv;
}

Transform operator*(const Transform& first, const Transform& second) {
    Transform product;
    for (std::size_t row = 0; row < 3; ++row) product.a[row] = second.transposed(first.a[row]);
    product.t = first.point(second.t);
    return product;
}

Real Transform::rounding(Real reach) const {
    const auto sum = [](Vec3 v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
    const Real growth = std::max({sum(a[0]), sum(a[1]), sum(a[2])});
    return 0x1p-49 * (max_abs(t) + growth * reach);
}

Transform Transform::translate(Vec3 by) {
    Transform m;
    m.t = by;
    return m;
}

Transform Transform::scale(Vec3 by) {
    Transform m;
    m.a = {Vec3{by.x, 0, 0}, Vec3{0, by.y, 0}, Vec3{0, 0, by.z}};
    return m;
}

Transform Transform::rotate(Vec3 axis, Real angle_rad) {
    const Vec3 k = normalize(axis);
    const Real c = std::cos(angle_rad);
    const Real s = std::sin(angle_rad);
    const auto row = [&](Vec3 e) {  // Rodrigues' formula, transposed
        return c * e - s * cross(k, e) + (1 - c) * dot(k, e) * k;
    };
    Transform m;
    m.a = {row({1, 0, 0}), row({0, 1, 0}), row({0, 0, 1})};
    return m;
}

}  // namespace bouguer::renderer
