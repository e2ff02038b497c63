// SPDX-License-Identifier: Apache-2.0
// The seed's material as plain data.
#pragma once

#include <optional>

#include "renderer/core/vec3.h"
#include "renderer/spectrum/spectrum.h"

namespace bouguer::renderer {

/// Bouguer-Beer absorption: internal transmittance after `thickness` scene units inside the object.
struct Absorption {
    SpectrumPtr transmittance;
    Real thickness = 1;
};

/// The seed's surface (equations 3 and 4).
struct HallMaterial {
    SpectrumPtr reflectance;    ///< F_sr, in [0, 1]
    SpectrumPtr transmittance;  ///< F_st, in [0, 1]
    Real k_sr = 0;              ///< share that is reflected, [0, 1]
    Real k_st = 0;              ///< share that is transmitted, [0, 1]; 0 is opaque
    Real n = 1;    ///< n', exponent of (L.N), [0, 1e6]; also n_i when seen as a neighbour
    Real ior = 1;  ///< index of refraction of the inside, [1, 10]
    std::optional<Absorption> absorption;
    bool mirror = false;  ///< whether a reflected ray is followed
};

}  // namespace bouguer::renderer
