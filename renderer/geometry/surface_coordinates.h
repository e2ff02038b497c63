// SPDX-License-Identifier: Apache-2.0
// Where on a shape a texture lies: the coordinates (u, v) of its surface.
//
// Seen from the side that the normal points to, u goes to the right and v up: (dp/du x dp/dv) . n
// is positive everywhere, so that a picture is never mirrored. Up is +y, as for cameras. The
// coordinates are those of the shape before its transform and go with it: a picture on an object
// that is turned is turned, on one that is mirrored it is mirrored. /docs/materials has a drawing.
#pragma once

#include "renderer/core/transform.h"
#include "renderer/core/vec3.h"

namespace bouguer::renderer {

/// The frame of a surface with unit normal `n` (its z axis): u along x, v along y. On walls v is
/// up, on floors (n = +y) it is -z and on ceilings +z, u being +x there. Continuous in `n` but for
/// two directions: by the hairy ball theorem no rule does without, and no rule with v up on all
/// walls does with one. They are put where the normal of hardly anything points: back, and down
/// from or up to a slope of 42.5 degrees, which lies between those of roofs, 40 and 45.
[[nodiscard]] Frame upright_frame(Vec3 n);

/// At the point `q` of the unit sphere: u is the longitude, counter-clockwise seen from the pole +y
/// and 0 at +x, v the latitude, 0 at the pole -y. Both in [0, 1].
[[nodiscard]] Vec2 sphere_uv(Vec3 q);

/// On the face of the cube [-1, 1]^3 with outward normal `n`: the place in its upright_frame(), [0,
/// 1].
[[nodiscard]] Vec2 box_uv(Vec3 n, Vec3 q);

/// On the unit disk: the place in the square around it, [0, 1].
[[nodiscard]] constexpr Vec2 disk_uv(Real x, Real y) { return {0.5 + 0.5 * x, 0.5 + 0.5 * y}; }

/// On the side of the unit cylinder: the angle about z, counter-clockwise and 0 at +x, and the
/// height. Both in [0, 1].
[[nodiscard]] Vec2 cylinder_side_uv(Vec3 q);

/// Of a plane, in the lengths of its own space: affine in the point.
class PlaneCoordinates {
  public:
    /// For a plane with normal `n`, not zero, that is placed by the inverse of `to_shape`. (u, v)
    /// is (0, 0) at the point of the plane that is nearest to the origin of its own space.
    PlaneCoordinates(Vec3 n, const Transform& to_shape);
    /// The same for points that are counted from `origin`.
    [[nodiscard]] PlaneCoordinates relative_to(Vec3 origin) const;
    [[nodiscard]] Vec2 at(Vec3 p) const {
        return {dot(u_, p) + at_zero_.x, dot(v_, p) + at_zero_.y};
    }

  private:
    Vec3 u_, v_;
    Vec2 at_zero_;
};

}  // namespace bouguer::renderer
