// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/surface_coordinates.h"

#include <cmath>

namespace bouguer::renderer {
namespace {

/// Angle about z as a share of a turn, [0, 1).
Real turn(Real x, Real y) {
    const Real share = std::atan2(y, x) / (2 * kPi);
    if (share >= 0) return share;
    return share + 1 < 1 ? share + 1 : 0;  // of -1e-20 the sum rounds to 1
}

}  // namespace

// The part of +y in the plane turns all walls upright, but has no direction on floors; n x X alone,
// the turn about +x, would be upright on the walls +z and -y, but upside down on -z. Their sum is
// zero only at n = (0, +-sqrt(1 - k^2), -k). It is one of the quadratic fields of the Riemann
// sphere, whose two zeros can be put anywhere.
Frame upright_frame(Vec3 n) {
    constexpr Real kBack = 0.6755902076156604;  // sin 42.5 degrees
    const Vec3 about_x{0, n.z, -n.y};
    Vec3 v = Vec3{0, 1, 0} - n.y * n + kBack * about_x;
    constexpr Real kLeast = 1e-12;  // rounding would decide where it points
    if (max_abs(v) < kLeast) v = about_x;
    Frame frame(n);
    frame.x = normalize(cross(v, n));
    frame.y = cross(n, frame.x);
    return frame;
}

Vec2 sphere_uv(Vec3 q) {
    return {turn(q.x, -q.z), 0.5 + std::atan2(q.y, std::hypot(q.x, q.z)) / kPi};
}

Vec2 box_uv(Vec3 n, Vec3 q) {
    const Frame frame = upright_frame(n);
    return disk_uv(dot(frame.x, q), dot(frame.y, q));
}

Vec2 cylinder_side_uv(Vec3 q) { return {turn(q.x, q.y), q.z}; }

PlaneCoordinates::PlaneCoordinates(Vec3 n, const Transform& to_shape) {
    const Frame frame = upright_frame(normalize(n));
    u_ = to_shape.transposed(frame.x);
    v_ = to_shape.transposed(frame.y);
    at_zero_ = {dot(frame.x, to_shape.t), dot(frame.y, to_shape.t)};
}

PlaneCoordinates PlaneCoordinates::relative_to(Vec3 origin) const {
    PlaneCoordinates result = *this;
    result.at_zero_ = at(origin);
    return result;
}

}  // namespace bouguer::renderer
