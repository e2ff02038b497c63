// SPDX-License-Identifier: Apache-2.0
// Analysis of a scene before a ray is shot: what it needs, what is left out and why.
#pragma once

#include <string>

#include "renderer/report.h"
#include "renderer/scene/scene.h"
#include "renderer/settings.h"
#include "renderer/spectrum/spectral_basis.h"

namespace bouguer::renderer {

/// What a scene needs, as yes and no. A kernel compiled without a feature gives the same picture of
/// a scene that lacks it.
struct SceneNeeds {
    bool transparency = false;  ///< some material in use transmits
    bool refraction = false;    ///< ... and bends rays (index other than 1)
    bool absorption = false;    ///< ... and absorbs
    bool dispersion = false;    ///< ... and parts wavelengths
    bool textures = false;      ///< some colour varies over a surface
    bool emission = false;      ///< a surface gives out light by itself
    bool ambient = false;       ///< k_a > 0
    bool hemisphere = false;    ///< ambient weights from covered hemisphere: random directions
    bool mirrors = false;       ///< reflected rays are followed
    bool environment = false;
    bool wavelengths =
        false;  ///< colour differs between materials or lamps: one number is not enough
    bool several_lights = false;
    bool shadows = false;  ///< there is a lamp, or an environment that lights matt surfaces
};

/// Looks at the materials that objects use, the lamps and the environment. Pure.
[[nodiscard]] SceneNeeds analyse(const Scene& scene);

/// The numbers that a path carries: three for the rgb integrator; one where colour does not matter;
/// else the quadrature. The general form (settings.specialise == false) never takes the one number.
[[nodiscard]] SpectralBasis choose_basis(const Scene& scene, const SceneNeeds& needs,
                                         const RenderSettings& settings);

/// Bytes that the film of a job takes.
[[nodiscard]] std::uint64_t film_memory_bytes(const RenderSettings& settings);

/// Largest relative error in X, Y or Z that the wavelength quadrature makes against 1 nm, over
/// every lamp x material colour of the scene. No rays; exact for what light meets first.
[[nodiscard]] double quadrature_error(const Scene& scene, double step_nm,
                                      const Observer& observer = standard_observer());

/// The observer of a render; the standard one for a name that is not known.
[[nodiscard]] const Observer& observer_of(const RenderSettings& settings);

}  // namespace bouguer::renderer
