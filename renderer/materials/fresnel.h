// SPDX-License-Identifier: Apache-2.0
// How much of unpolarised light a smooth boundary reflects.
#pragma once

#include <cstddef>

#include "renderer/core/span_math.h"
#include "renderer/spectrum/refractive_index.h"
#include "renderer/spectrum/spectrum.h"

namespace bouguer::renderer {

/// Fresnel's reflectance in [0, 1] of the boundary to a medium of relative index n + i k (the far
/// side's over the near side's) for light whose angle to the normal has this cosine, in [0, 1];
/// n > 0, k >= 0. With k = 0 it is a dielectric's: 1 where light is totally reflected, 0 everywhere
/// for n = 1. [Born and Wolf, Principles of Optics, §1.5.2 and §14.2]
[[nodiscard]] double fresnel_reflectance(double cosine, double n, double k);

/// Likewise lane by lane on rows of `blocks` Float8s. Padding gives numbers without meaning, but
/// finite ones.
void fresnel_reflectances(Float8* to, double cosine, const Float8* n, const Float8* k,
                          std::size_t blocks);

/// The reflectance at normal incidence, ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2), as a spectrum.
[[nodiscard]] SpectrumPtr normal_reflectance(const ComplexIndex& index);

}  // namespace bouguer::renderer
