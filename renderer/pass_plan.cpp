// SPDX-License-Identifier: Apache-2.0
#include "renderer/pass_plan.h"

#include <algorithm>

namespace bouguer::renderer {

std::vector<Unit> units_of_pass(const Crop& area, std::uint32_t pass, std::uint32_t first_sample,
                                std::uint32_t num_samples) {
    const int side = num_samples <= 16 ? 32 : 16;
    std::vector<Unit> units;
    for (int y = area.y; y < area.y + area.height; y += side) {
        for (int x = area.x; x < area.x + area.width; x += side) {
            units.push_back({pass, x, y, std::min(side, area.x + area.width - x),
                             std::min(side, area.y + area.height - y), first_sample, num_samples});
        }
    }
    return units;
}

}  // namespace bouguer::renderer
