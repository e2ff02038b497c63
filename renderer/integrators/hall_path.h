// SPDX-License-Identifier: Apache-2.0
// What the Hall kernel keeps while it walks the tree of rays.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "renderer/core/hash.h"
#include "renderer/core/span_math.h"
#include "renderer/geometry/geometry.h"
#include "renderer/integrators/integrator.h"
#include "renderer/materials/surface.h"
#include "renderer/media/medium_stack.h"

namespace bouguer::renderer {

/// Working memory of one thread: rows for every depth of the tree.
class HallScratch final : public TraceScratch {
  public:
    HallScratch(const SpectralTable& table, int max_depth)
        : radiance(table.blocks()),
          light(table.blocks()),
          colours(table),
          colours_in_shadow(table),
          blocks_(table.blocks()),
          throughput_(blocks_ * static_cast<std::size_t>(max_depth + 2)),
          peaks_(static_cast<std::size_t>(max_depth + 2)) {}

    /// The weight with which a ray of `depth` reaches the camera.
    Float8* throughput(int depth) {
        return throughput_.data() + blocks_ * static_cast<std::size_t>(depth);
    }

    /// The largest of its numbers, before absorption on the ray's own way.
    float& peak(int depth) { return peaks_[static_cast<std::size_t>(depth)]; }

    Float8Vector radiance;                      ///< of the sample, so far
    Float8Vector light;                         ///< tint of a shadow ray, or the ambient illuminant
    SurfaceColours colours, colours_in_shadow;  ///< where a ray is; where its shadow rays are

  private:
    std::size_t blocks_;
    Float8Vector throughput_;
    std::vector<float> peaks_;
};

/// A ray's place in the tree of rays.
struct Path {
    int depth = 0;
    std::uint64_t node = 1;       ///< names the place
    MediumStack media;            ///< the bodies around the ray
    bool one_wavelength = false;  ///< the others ended where an index parted them

    /// `number` tells the rays apart that leave one point.
    [[nodiscard]] Path next(const MediumStack& beyond, std::uint64_t number, bool parted) const {
        return {depth + 1, mix(node + number), beyond, one_wavelength || parted};
    }
};

/// A hit seen from the side that the ray comes from.
struct SurfacePoint {
    Hit hit;
    const Surface* surface;
    std::uint64_t body;
    bool entering;  ///< the ray comes from outside the body
    bool is_sheet;
    Vec3 n, ng;  ///< shading and geometric normal, turned to the viewer
    Vec3 wo;     ///< to the viewer
    Vec2 uv;     ///< only where the surface has a texture

    /// The ray comes out of a body that light goes through.
    [[nodiscard]] bool comes_out() const { return !entering && surface->transmits && !is_sheet; }
};

constexpr std::uint64_t body_of(const Hit& hit) {
    return (std::uint64_t{hit.object} << 32U) | hit.instance;
}

}  // namespace bouguer::renderer
