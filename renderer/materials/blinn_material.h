// SPDX-License-Identifier: Apache-2.0
// Blinn's surface: Torrance and Sparrow's facets for computer graphics [Blinn 1977].
//
//     I = I_l (k_d R_d (L.N) + k_s C D G F / (N.V))
//     D = (c3^2 / ((N.H)^2 (c3^2 - 1) + 1))^2
//
// D is the distribution that Blinn recommends, that of [Trowbridge and Reitz 1975]: ellipsoids of
// eccentricity c3, 0 for a mirror and 1 for the roughest; its peak is 1, as printed there, and it
// is not normalised. G is the shadowing of V-shaped grooves, F Fresnel's reflectance of a
// dielectric.
#pragma once

#include "renderer/materials/material_needs.h"
#include "renderer/materials/surface.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {

struct BlinnMaterial {
    SurfaceSpectrum diffuse = constant_spectrum(1);   ///< R_d, in [0, 1]
    SurfaceSpectrum specular = constant_spectrum(1);  ///< C, in [0, 1]
    Real k_d = 0, k_s = 0;                            ///< [0, 1]
    Real c3 = 0.35;                                   ///< [1e-4, 1]
    ComplexIndex index{constant_spectrum(1.5), constant_spectrum(0)};
    bool mirror = false;  ///< whether a reflected ray is followed, of weight k_s C F
};

[[nodiscard]] MaterialNeeds needs_of(const BlinnMaterial& material);
[[nodiscard]] Surface bind(const BlinnMaterial& material, const SpectralBasis& basis,
                           SpectralTable& table);

}  // namespace bouguer::renderer
