// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/absorption.h"

#include <algorithm>
#include <cmath>

namespace bouguer::renderer {

std::size_t bind_absorption(const Absorption& absorption, const SpectralBasis& basis,
                            SpectralTable& table) {
    constexpr double kOpaque = -1e30;
    std::vector<float> row = basis.factor(*absorption.transmittance);
    for (float& t : row) {
        const double log_t =
            t > 0 ? std::log(static_cast<double>(t)) / absorption.thickness : kOpaque;
        t = static_cast<float>(std::clamp(log_t, kOpaque, 0.0));
    }
    return table.add(row);
}

}  // namespace bouguer::renderer
