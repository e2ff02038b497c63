// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/spectra.h"
#include "renderer/textures/texture.h"

namespace bouguer::renderer {

std::vector<SpectrumPtr> SurfaceSpectrum::parts() const {
    if (!texture) return {spectrum};
    std::vector<SpectrumPtr> parts;
    for (const SpectrumPtr& part : texture->spectra())
        parts.push_back(product_spectrum(part, spectrum));
    return parts;
}

}  // namespace bouguer::renderer
