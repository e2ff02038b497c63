// SPDX-License-Identifier: Apache-2.0
// A scene's spectra in the basis of one render: what the Hall kernel reads in its inner loops.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/core/span_math.h"
#include "renderer/scene/scene.h"
#include "renderer/spectrum/spectral_basis.h"

namespace bouguer::renderer {

/// A Hall material bound to a basis. Rows are those of HallTables::spectra.
struct HallSurface {
    float k_sr = 0, k_st = 0;
    Real n = 1;
    Real ior = 1;
    bool mirror = false;     ///< a reflected ray is followed
    bool transmits = false;  ///< a refracted ray is followed
    bool absorbs = false;
    std::size_t reflectance = 0, transmittance = 0;  ///< F_sr, F_st
    std::size_t log_transmittance = 0;               ///< ln t for one scene unit, in [-1e30, 0]
    /// F_sr^n and F_st^n: what the surface gives as a neighbour in the ambient sums of equations 4
    /// and 3.
    std::size_t neighbour_reflectance = 0, neighbour_transmittance = 0;
};

/// Immutable after construction.
class HallTables {
  public:
    HallTables(const Scene& scene, const SpectralBasis& basis);

    SpectralTable spectra;
    std::vector<HallSurface> surfaces;          ///< by material
    std::vector<std::uint32_t> object_surface;  ///< by object
    std::vector<bool> object_is_sheet;  ///< disks: no inside, so no refraction and no absorption
    std::vector<std::size_t> light_emission;        ///< by lamp
    std::optional<std::size_t> environment;         ///< radiance of rays that leave
    std::optional<std::size_t> ambient_illuminant;  ///< empty: what arrives from the lamps

    [[nodiscard]] const HallSurface& surface_of(std::uint32_t object) const {
        return surfaces[object_surface[object]];
    }
    [[nodiscard]] const Float8* row(std::size_t i) const { return spectra.row(i); }
};

/// (L.N)^n, 1 for n = 0; `cosine` in (0, 1]. Whole exponents, the common ones, by repeated
/// squaring.
[[nodiscard]] inline float lobe(Real cosine, Real n) {
    constexpr Real kManySquarings = 1024;
    if (n > kManySquarings || n != std::floor(n)) return static_cast<float>(std::pow(cosine, n));
    Real power = 1;
    for (auto rest = static_cast<unsigned>(n); rest != 0; rest >>= 1U, cosine *= cosine) {
        if ((rest & 1U) != 0) power *= cosine;
    }
    return static_cast<float>(power);
}

}  // namespace bouguer::renderer
