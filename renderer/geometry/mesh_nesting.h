// SPDX-License-Identifier: Apache-2.0
// Which closed pieces of a mesh lie inside which.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "renderer/geometry/shape.h"

namespace bouguer::renderer {

/// The closed pieces of a mesh.
struct MeshPieces {
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t count = 0;
    std::vector<std::uint32_t> of;  ///< by triangle; kNone for one that is of no closed piece
    std::vector<bool> faces_in;     ///< by triangle: winds so that its piece would be inside out
};

/// For every piece the outermost one that it lies in; itself when it lies in none. Pieces do not
/// cross each other. From near the tip of a piece it looks for the nearest triangle of another:
/// that belongs to the piece around it, or to one beside it. kNone: not found out in a number of
/// steps that is in proportion to the mesh, as may be with ten thousands of pieces one inside the
/// other.
[[nodiscard]] std::vector<std::uint32_t> outermost_pieces(const TriangleMesh& mesh,
                                                          const MeshPieces& pieces);

}  // namespace bouguer::renderer
