// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/surface.h"

#include "renderer/spectrum/refractive_index.h"

namespace bouguer::renderer {

void bind_inside(Surface& surface, const Spectrum& ior, const std::optional<Absorption>& absorption,
                 const SpectralBasis& basis, SpectralTable& table) {
    surface.transmits = true;
    surface.ior = ior.at(kLineD_nm);
    if (!ior.is_constant() && basis.has_wavelengths()) surface.dispersive_ior = &ior;
    if (absorption) surface.absorption = bind_absorption(*absorption, basis, table);
}

}  // namespace bouguer::renderer
