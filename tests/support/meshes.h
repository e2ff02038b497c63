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

/// A torus about z: `ring` is the radius of its middle circle, `tube` that of its cross-section.
[[nodiscard]] std::shared_ptr<const TriangleMesh> torus(Real ring, Real tube, int around,
                                                        int across);

/// Two triangles that cover the square [-half, half]^2 in z = 0 and face +z; uv = place in it.
[[nodiscard]] std::shared_ptr<const TriangleMesh> square(Real half);

}  // namespace bouguer::renderer::test
