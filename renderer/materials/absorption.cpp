// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/absorption.h"

#include <algorithm>
#include <cmath>

namespace bouguer::renderer {

std::size_t bind_absorption(const Absorption& absorption, const SpectralBasis& basis,
                            SpectralTable& table) {
    constexpr double kOpaque = -1e30;
    std::vector<double> logs;
    for (const double t : basis.factor(*absorption.transmittance)) {
        const double log_t = t > 0 ? std::log(t) / absorption.thickness : kOpaque;
        logs.push_back(std::clamp(log_t, kOpaque, 0.0));
    }
    return table.add_split(logs);
}

}  // namespace bouguer::renderer
