// SPDX-License-Identifier: Apache-2.0
// What a material asks of a render, for the plan.
#pragma once

#include <vector>

#include "renderer/materials/absorption.h"
#include "renderer/textures/texture.h"

namespace bouguer::renderer {

struct MaterialNeeds {
    /// Everything that colours light: reflectances, transmittances, those of absorption and of
    /// metals at normal incidence.
    std::vector<SurfaceSpectrum> colours;
    bool transmits = false;     ///< rays go through
    bool mirror = false;        ///< reflected rays are followed
    bool absorbs = false;       ///< ... and lose light on their way inside
    SpectrumPtr ior = nullptr;  ///< of a body that transmits
};

}  // namespace bouguer::renderer
