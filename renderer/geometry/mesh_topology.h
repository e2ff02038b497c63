// SPDX-License-Identifier: Apache-2.0
// Whether a mesh has an inside, and on which side it is.
#pragma once

#include <memory>

#include "renderer/geometry/shape.h"

namespace bouguer::renderer {

/// The mesh as light that goes through it needs it, with what was found in its `topology`: vertices
/// at equal positions are one; of triangles in one place the first stays; the triangles of a piece
/// wind alike; and a piece that is wound inside out is turned round, together with everything
/// inside it: a cavity, which winds the other way, stays one. A mesh that is open keeps its
/// triangles as they are, but for doubled ones. One that was mended already is returned as it is.
/// O(n log n) in triangles. Thread-safe.
[[nodiscard]] std::shared_ptr<const TriangleMesh> mended_mesh(
    const std::shared_ptr<const TriangleMesh>& mesh);

}  // namespace bouguer::renderer
