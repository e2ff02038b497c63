// SPDX-License-Identifier: Apache-2.0
// What the Hall kernel keeps while it walks the tree of rays.
#pragma once

#include "renderer/core/span_math.h"
#include "renderer/integrators/hall_tables.h"
#include "renderer/integrators/integrator.h"
#include "renderer/integrators/ray_queue.h"
#include "renderer/materials/surface.h"
#include "renderer/media/interface.h"

namespace bouguer::renderer {

/// Working memory of one thread.
class HallScratch final : public TraceScratch {
  public:
    HallScratch(const HallTables& tables, const Geometry& geometry)
        : radiance(tables.spectra.blocks()),
          numbers(tables.spectra.blocks()),
          tint(tables.spectra.blocks()),
          colours(tables.spectra),
          colours_in_shadow(tables.spectra),
          rays(tables.spectra.blocks()),
          interfaces(geometry, tables.bodies) {}

    Float8Vector radiance;                      ///< of the sample, so far
    Float8Vector numbers;                       ///< what is used at once
    Throughput tint;                            ///< what bodies leave of the light of a lamp
    SurfaceColours colours, colours_in_shadow;  ///< where a ray is; where its shadow rays are
    RayQueue rays;
    InterfaceFinder interfaces;
    std::optional<Vec3> camera_at;  ///< where camera_media was found
    MediumStack camera_media;
};

/// An interface seen from the side that the ray comes from.
struct SurfacePoint {
    Interface face;
    const Surface* surface;
    Vec3 n, ng;  ///< shading and geometric normal, turned to the viewer
    Vec3 wo;     ///< to the viewer
    Vec2 uv;     ///< only where the surface has a texture

    [[nodiscard]] bool is_sheet() const { return face.matter == Matter::Sheet; }
    /// The ray comes out of a body that light goes through.
    [[nodiscard]] bool comes_out() const { return face.matter == Matter::Body && !face.entering; }
};

}  // namespace bouguer::renderer
