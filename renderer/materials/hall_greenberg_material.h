// SPDX-License-Identifier: Apache-2.0
// The model that the seed improves: Hall and Greenberg's, a matt part, a highlight, and rays that
// Fresnel's equations divide at the boundary, by wavelength [Hall and Greenberg 1983, eq. 7].
//
//     I = k_dr R_d I_l (L.N) + k_sr C F(lambda) I_l (N.H)^n            lamp on the viewer's side
//       + k_st C_t (1 - F(lambda)) I_l (N.H_t)^n_t                     lamp behind
//       + k_sr C F(lambda) I(reflected) + k_st C_t (1 - F(lambda)) I(refracted)
//
// H_t is the normal of the facet that would refract the lamp's light to the viewer; between equal
// indices there is none, and the angle to the way straight through takes its place. What is lost on
// the way inside is `absorption`.
#pragma once

#include "renderer/materials/material_needs.h"
#include "renderer/materials/surface.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {

struct HallGreenbergMaterial {
    SurfaceSpectrum diffuse = constant_spectrum(1);        ///< R_d, in [0, 1]
    SurfaceSpectrum specular = constant_spectrum(1);       ///< C, in [0, 1]
    SurfaceSpectrum transmittance = constant_spectrum(1);  ///< C_t, in [0, 1]
    Real k_dr = 0, k_sr = 0, k_st = 0;                     ///< [0, 1]
    Real n = 20, n_t = 20;  ///< exponents of the highlights, [0, 1e6]
    /// Of the inside; k = 0 where k_st > 0.
    ComplexIndex index{constant_spectrum(1.5), constant_spectrum(0)};
    std::optional<Absorption> absorption;
    bool mirror = true;  ///< whether a reflected ray is followed
};

[[nodiscard]] MaterialNeeds needs_of(const HallGreenbergMaterial& material);
[[nodiscard]] Surface bind(const HallGreenbergMaterial& material, const SpectralBasis& basis,
                           SpectralTable& table);

}  // namespace bouguer::renderer
