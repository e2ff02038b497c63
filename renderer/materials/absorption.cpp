// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/absorption.h"

#include <algorithm>
#include <cmath>

#include "renderer/core/attenuation.h"

namespace bouguer::renderer {

BoundAbsorption bind_absorption(const Absorption& absorption, const SpectralBasis& basis,
                                SpectralTable& table) {
    BoundAbsorption bound;
    std::vector<double> logs;
    for (const double t : basis.exact_factor(*absorption.transmittance)) {
        const double log_t = t > 0 ? std::log(t) / absorption.thickness : kBlack;
        logs.push_back(std::clamp(log_t, kBlack, 0.0));
        if (logs.back() > kBlack) bound.steepest = std::max(bound.steepest, -logs.back());
    }
    bound.log_t = table.add_split(logs);
    return bound;
}

}  // namespace bouguer::renderer
