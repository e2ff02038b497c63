// SPDX-License-Identifier: Apache-2.0
#include "renderer/samplers/wavelength_sampler.h"

#include <algorithm>
#include <numeric>

#include "renderer/samplers/warp.h"

namespace bouguer::renderer {

WavelengthSampler::WavelengthSampler(const SpectralBasis& basis)
    : nodes_nm_(basis.wavelengths_nm()), step_nm_(basis.step_nm()) {
    if (nodes_nm_.empty()) return;
    for (const auto& [x, y, z] : basis.weights()) cumulative_.push_back(x + y + z);
    std::partial_sum(cumulative_.begin(), cumulative_.end(), cumulative_.begin());
    const double whole = cumulative_.back();
    for (double& p : cumulative_) p /= whole;
}

WavelengthSample WavelengthSampler::sample(Vec2 u) const {
    const auto it = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, u.x);
    const auto node = static_cast<std::size_t>(it - cumulative_.begin());
    const double probability = *it - (node > 0 ? cumulative_[node - 1] : 0);
    const double lambda_nm = nodes_nm_[node] + step_nm_ * sample_tent(u.y);
    return {node, static_cast<float>(1 / probability),
            std::clamp(lambda_nm, kLambdaMin_nm, kLambdaMax_nm)};
}

}  // namespace bouguer::renderer
