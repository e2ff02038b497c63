// SPDX-License-Identifier: Apache-2.0
// Phong's surface: Lambert's cosine and a highlight about the mirrored direction R of the light
// [Phong 1975].
//
//     I = I_l (k_d R_d (L.N) + k_s C (R.V)^n)
//
// Phong's highlight has the colour of the light; a tint C is ours, 1 by default.
#pragma once

#include "renderer/materials/material_needs.h"
#include "renderer/materials/surface.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {

struct PhongMaterial {
    SurfaceSpectrum diffuse = constant_spectrum(1);   ///< R_d, in [0, 1]
    SurfaceSpectrum specular = constant_spectrum(1);  ///< C, in [0, 1]
    Real k_d = 0, k_s = 0;                            ///< [0, 1]
    Real n = 20;                                      ///< exponent of the highlight, [0, 1e6]
    bool mirror = false;  ///< whether a reflected ray is followed, of weight k_s C
};

[[nodiscard]] MaterialNeeds needs_of(const PhongMaterial& material);
[[nodiscard]] Surface bind(const PhongMaterial& material, const SpectralBasis& basis,
                           SpectralTable& table);

}  // namespace bouguer::renderer
