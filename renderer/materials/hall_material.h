// SPDX-License-Identifier: Apache-2.0
// The seed's surface, equations 3 and 4 of [Lee et al.]: a share k_sr of the light is reflected
// with the colour F_sr, a share k_st goes through with the colour F_st, and (L.N)^n' shapes the
// light of lamps.
//
//     I = k_sr I_l F_sr (L.N)^n'  (lamp on the viewer's side)
//     I = k_st I_l F_st (-L.N)^n'  (lamp behind)
#pragma once

#include <memory>
#include <optional>

#include "renderer/materials/material_needs.h"
#include "renderer/materials/surface.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {

struct HallMaterial {
    SurfaceSpectrum reflectance;    ///< F_sr, in [0, 1]
    SurfaceSpectrum transmittance;  ///< F_st, in [0, 1]
    Real k_sr = 0;                  ///< share that is reflected, [0, 1]
    Real k_st = 0;                  ///< share that is transmitted, [0, 1]; 0 is opaque
    Real n = 1;  ///< n', exponent of (L.N), [0, 1e6]; also n_i when seen as a neighbour
    SpectrumPtr ior = constant_spectrum(1);  ///< index of refraction of the inside, [1, 10]
    std::optional<Absorption> absorption;
    bool mirror = false;  ///< whether a reflected ray is followed
};

[[nodiscard]] MaterialNeeds needs_of(const HallMaterial& material);
[[nodiscard]] Surface bind(const HallMaterial& material, const SpectralBasis& basis,
                           SpectralTable& table);

/// (L.N)^n, 1 for n = 0; `cosine` in [0, 1]. Whole exponents, the common ones, by repeated
/// squaring.
[[nodiscard]] float cosine_power(Real cosine, Real n);

}  // namespace bouguer::renderer
