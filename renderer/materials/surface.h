// SPDX-License-Identifier: Apache-2.0
// A material in the numbers of one render: what an integrator sees of it.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "renderer/materials/absorption.h"
#include "renderer/materials/reflection_model.h"

namespace bouguer::renderer {

/// Immutable once bound. Numbers of spectra are rows of the table that it was bound to; the
/// description outlives it.
struct Surface {
    std::unique_ptr<const ReflectionModel> model;
    bool mirror = false;     ///< a reflected ray is followed
    bool transmits = false;  ///< a refracted ray is followed

    Real ior = 1;  ///< of the inside, at 587.6 nm
    /// The index by wavelength where it varies, null where it is `ior` everywhere.
    const Spectrum* dispersive_ior = nullptr;
    std::optional<BoundAbsorption> absorption;

    /// F_sr^n and F_st^n, means over the surface: what it gives as a neighbour in the ambient sums
    /// of equations 4 and 3.
    std::size_t neighbour_reflectance = 0, neighbour_transmittance = 0;

    std::optional<BoundSpectrum> emission;  ///< radiance that it gives out by itself
    bool has_texture = false;               ///< some colour needs surface coordinates
};

/// Sets everything about the inside of a body that transmits. In a basis without wavelengths
/// nothing disperses.
void bind_inside(Surface& surface, const Spectrum& ior, const std::optional<Absorption>& absorption,
                 const SpectralBasis& basis, SpectralTable& table);

}  // namespace bouguer::renderer
