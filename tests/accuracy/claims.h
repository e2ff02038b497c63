// SPDX-License-Identifier: Apache-2.0
// Holds what renders claim about their noise against the truth: a reference of another seed and
// many more samples.
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "renderer/render.h"

namespace bouguer::test {

/// At one number of samples, over all seeds.
struct ClaimRow {
    double claimed = 0;  ///< root of the mean squared claim
    double truth = 0;    ///< root of the mean squared error, the reference's own noise taken off
    double covered =
        0;  ///< share of seeds whose 95 % interval holds the error of the expected picture, `truth`
    int seeds = 0;
    [[nodiscard]] double ratio() const { return claimed / truth; }
};

struct ClaimSettings {
    int seeds = 20;
    std::uint32_t samples =
        64;  ///< of each seed; rows are those pass ends that are powers of four, from 4
    std::uint32_t reference_factor = 100;
    int threads = 2;
};

/// By samples a pixel. The reference takes seed 0, the others 1, 2, ...
[[nodiscard]] std::map<std::uint32_t, ClaimRow> compare_claims(
    const std::shared_ptr<const renderer::Scene>& scene, renderer::RenderSettings settings,
    const ClaimSettings& claims);

}  // namespace bouguer::test
