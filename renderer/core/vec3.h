// SPDX-License-Identifier: Apache-2.0
// Points and directions. The scalar of all geometry outside Embree is `Real`.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace bouguer::renderer {

using Real = double;

inline constexpr Real kPi = 3.14159265358979323846;
inline constexpr Real degrees_to_radians(Real deg) { return deg * (kPi / 180); }

/// A point (scene units), a direction or a normal; which of them, the name says.
struct Vec3 {
    Real x = 0, y = 0, z = 0;
    bool operator==(const Vec3&) const = default;

    constexpr Vec3 operator-() const { return {-x, -y, -z}; }
    constexpr Vec3& operator+=(Vec3 b) { return *this = {x + b.x, y + b.y, z + b.z}; }
    constexpr Real operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator*(Vec3 a, Real s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr Vec3 operator*(Real s, Vec3 a) { return a * s; }
constexpr Vec3 operator/(Vec3 a, Real s) { return {a.x / s, a.y / s, a.z / s}; }
constexpr Real dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Real length(Vec3 a) { return std::sqrt(dot(a, a)); }
inline Vec3 normalize(Vec3 a) { return a / length(a); }
inline Real max_abs(Vec3 a) { return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}); }
inline bool is_finite(Vec3 a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
constexpr Vec3 min(Vec3 a, Vec3 b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
constexpr Vec3 max(Vec3 a, Vec3 b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

/// A point of the unit square or of a surface's (u, v) plane.
struct Vec2 {
    Real x = 0, y = 0;
    bool operator==(const Vec2&) const = default;
};

/// Half a line. `d` is unit; lengths along it are in scene units.
struct Ray {
    Vec3 o, d;
    constexpr Vec3 at(Real t) const { return o + t * d; }
};

/// An orthonormal frame whose z axis is the unit vector `n` [Duff et al. 2017, listing 3].
struct Frame {
    Vec3 x, y, z;
    explicit Frame(Vec3 n) : z(n) {
        const Real sign = std::copysign(Real(1), n.z);
        const Real a = -1 / (sign + n.z);
        const Real b = n.x * n.y * a;
        x = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
        y = {b, sign + n.y * n.y * a, -n.y};
    }
    constexpr Vec3 to_world(Vec3 local) const { return local.x * x + local.y * y + local.z * z; }
};

}  // namespace bouguer::renderer
