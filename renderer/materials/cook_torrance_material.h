// SPDX-License-Identifier: Apache-2.0
// Cook and Torrance's surface: facets by Beckmann's distribution, and Fresnel's reflectance by
// wavelength, which shifts the colour of a metal's highlight towards that of the light at grazing
// angles: the copper vase [Cook and Torrance 1982].
//
//     I = I_l (k_d R_d (L.N) + k_s C pi D G F(lambda) / (4 (N.V)))
//     D = exp(-tan^2(a) / m^2) / (pi m^2 cos^4(a)),  cos(a) = N.H
//
// D is normalised, and the divisor 4 is that of the facets' geometry, so that with F = 1 no more
// light leaves than came [Walter et al. 2007, §5.1]; the printed equation has pi in its place. F is
// exact for the index n + i k. As neighbour, a metal has its colour at normal incidence.
#pragma once

#include "renderer/materials/material_needs.h"
#include "renderer/materials/surface.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {

struct CookTorranceMaterial {
    SurfaceSpectrum diffuse = constant_spectrum(1);   ///< R_d, in [0, 1]
    SurfaceSpectrum specular = constant_spectrum(1);  ///< C, in [0, 1]
    Real k_d = 0, k_s = 1;                            ///< [0, 1], together at most 1
    Real m = 0.3;                                     ///< rms slope of the facets, [1e-4, 1]
    ComplexIndex index;
    bool mirror = false;  ///< whether a reflected ray is followed, of weight k_s C F
};

[[nodiscard]] MaterialNeeds needs_of(const CookTorranceMaterial& material);
[[nodiscard]] Surface bind(const CookTorranceMaterial& material, const SpectralBasis& basis,
                           SpectralTable& table);

}  // namespace bouguer::renderer
