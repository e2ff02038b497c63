// SPDX-License-Identifier: Apache-2.0
// The reflectances that textures of colours are mixed of.
#pragma once

#include <array>

#include "renderer/spectrum/spectrum.h"

namespace bouguer::renderer {

/// Of red, green and blue [Mallett and Yuksel 2019]. r, g and b of them, linear Rec.709, mix to a
/// reflectance that has that colour under D65, to rounding; they add up to 1 at every wavelength,
/// so that no mixture of numbers in [0, 1] leaves [0, 1]. Unlike srgb_spectrum() the mixture is
/// linear in the colour: filtering colours is filtering spectra. Constant beyond 380 to 780 nm.
///
/// As published, on 5 nm, they miss colours by up to 0.28 (CIE 1976) under our D65 and observer on
/// 1 nm; a 3 x 3 matrix, within 0.0011 of the identity, mixes them so that nothing is missed.
/// Thread-safe.
const std::array<SpectrumPtr, 3>& srgb_primary_reflectances();

}  // namespace bouguer::renderer
