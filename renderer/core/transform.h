// SPDX-License-Identifier: Apache-2.0
// Affine transforms in double precision.
#pragma once

#include <array>
#include <optional>

#include "renderer/core/vec3.h"

namespace bouguer::renderer {

/// p -> A p + t. Rows of `a` are the rows of A. The default is the identity. Immutable by habit;
/// thread-safe.
struct Transform {
    std::array<Vec3, 3> a{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    Vec3 t;
    bool operator==(const Transform&) const = default;

    [[nodiscard]] constexpr Vec3 direction(Vec3 v) const {
        return {dot(a[0], v), dot(a[1], v), dot(a[2], v)};
    }
    [[nodiscard]] constexpr Vec3 point(Vec3 p) const { return direction(p) + t; }
    /// A^T n: with the *inverse* of an object's transform this takes its normals to the world. Not
    /// normalised.
    [[nodiscard]] constexpr Vec3 transposed(Vec3 n) const {
        return n.x * a[0] + n.y * a[1] + n.z * a[2];
    }
    [[nodiscard]] constexpr Real determinant() const { return dot(a[0], cross(a[1], a[2])); }
    /// Empty when A cannot be inverted: its determinant is zero, not finite, or lost in rounding.
    [[nodiscard]] std::optional<Transform> inverse() const;
    /// How far off double precision may put a point whose coordinates are at most `reach`: two
    /// documents' numbers for one place agree to this. Eight units in the last place.
    [[nodiscard]] Real rounding(Real reach) const;
    [[nodiscard]] bool is_identity() const { return *this == Transform{}; }

    /// First `second`, then `first`: (first * second).point(p) == first.point(second.point(p)).
    friend Transform operator*(const Transform& first, const Transform& second);

    static Transform translate(Vec3 by);
    static Transform scale(Vec3 by);
    /// Right-handed turn by `angle_rad` about `axis` (any length but zero) through the origin.
    static Transform rotate(Vec3 axis, Real angle_rad);
};

}  // namespace bouguer::renderer
