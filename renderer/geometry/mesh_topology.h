// SPDX-License-Identifier: Apache-2.0
// Whether a mesh has an inside, and on which side it is.
#pragma once

#include <memory>

#include "renderer/geometry/shape.h"

namespace bouguer::renderer {

/// The mesh as light that goes through it needs it, with what was found in its `topology`:
/// - Vertices at equal positions are one.
/// - Of triangles in one place the first stays. Where that would leave the surface open and leaving
///   out both closes it, as where two cubes share a wall, both go.
/// - The triangles of a piece wind alike: as most of them did.
/// - A closed piece that is inside out is turned round, together with everything inside it: a
///   cavity, which winds the other way, stays one.
/// One that was mended before is returned as it is. O(n log n) in triangles. Thread-safe.
[[nodiscard]] std::shared_ptr<const TriangleMesh> mended_mesh(
    const std::shared_ptr<const TriangleMesh>& mesh);

}  // namespace bouguer::renderer
