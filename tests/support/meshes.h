// SPDX-License-Identifier: Apache-2.0
// Triangle meshes for tests: closed, counter-clockwise seen from outside.
#pragma once

#include <memory>

#include "renderer/geometry/shape.h"

namespace bouguer::renderer::test {

/// The unit sphere's icosahedron with every triangle cut into four `levels` times: 20 * 4^levels
/// triangles with vertices on the sphere. `smooth`: with the sphere's normals.
[[nodiscard]] std::shared_ptr<const TriangleMesh> icosphere(int levels, bool smooth = false);

/// The surface of the cube [-1, 1]^3, 12 triangles, 8 vertices.
[[nodiscard]] std::shared_ptr<const TriangleMesh> cube();

/// The surface of a box, 12 triangles.
[[nodiscard]] std::shared_ptr<const TriangleMesh> box_mesh(Vec3 min, Vec3 max);

/// A box as itself or as the mesh of its surface.
[[nodiscard]] Shape box_or_mesh(bool is_mesh, Vec3 min, Vec3 max);

/// A closed prism about z with `sides` flat sides: its corners lie `radius` from the axis, the
/// first one in the direction of x turned by `turn_rad`. Caps are fans about their middle.
[[nodiscard]] std::shared_ptr<const TriangleMesh> prism(Real radius, Real from_z, Real to_z,
                                                        int sides, Real turn_rad = 0);

/// A torus about z: `ring` is the radius of its middle circle, `tube` that of its cross-section.
[[nodiscard]] std::shared_ptr<const TriangleMesh> torus(Real ring, Real tube, int around,
                                                        int across);

/// Two triangles that cover the square [-half, half]^2 in z = 0 and face +z; uv = place in it.
[[nodiscard]] std::shared_ptr<const TriangleMesh> square(Real half);

}  // namespace bouguer::renderer::test
