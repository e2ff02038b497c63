// SPDX-License-Identifier: Apache-2.0
// A scene's spectra in the basis of one render: what the Hall kernel reads in its inner loops.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/core/span_math.h"
#include "renderer/materials/surface.h"
#include "renderer/media/body_table.h"
#include "renderer/scene/scene.h"
#include "renderer/spectrum/spectral_basis.h"

namespace bouguer::renderer {

/// Immutable after construction.
class HallTables {
  public:
    HallTables(const Scene& scene, const SpectralBasis& basis);

    SpectralTable spectra;
    std::vector<Surface> surfaces;                  ///< by material
    std::vector<std::uint32_t> object_surface;      ///< by object
    const BodyTable& bodies;                        ///< what light goes through, by priority
    std::vector<std::size_t> light_emission;        ///< by lamp
    std::optional<std::size_t> environment;         ///< radiance of rays that leave
    std::optional<std::size_t> ambient_illuminant;  ///< empty: what arrives from the lamps
    float brightest_emission = 0;  ///< largest number that a surface or the environment gives out

    [[nodiscard]] const Surface& surface_of(std::uint32_t object) const {
        return surfaces[object_surface[object]];
    }
    [[nodiscard]] const Float8* row(std::size_t i) const { return spectra.row(i); }
};

}  // namespace bouguer::renderer
