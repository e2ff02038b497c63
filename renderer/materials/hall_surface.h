// SPDX-License-Identifier: Apache-2.0
// The seed's material in the numbers of one render.
#pragma once

#include <cmath>
#include <cstddef>

#include "renderer/core/span_math.h"
#include "renderer/materials/hall_material.h"
#include "renderer/spectrum/spectral_basis.h"

namespace bouguer::renderer {

/// A Hall material bound to a basis. Numbers of spectra are rows of the table that bind_hall()
/// filled.
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

/// Puts the material's spectra into `table` as they stand in `basis`.
[[nodiscard]] HallSurface bind_hall(const HallMaterial& material, const SpectralBasis& basis,
                                    SpectralTable& table);

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
