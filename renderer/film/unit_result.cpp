// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/unit_result.h"

#include <algorithm>
#include <cmath>

namespace bouguer::renderer {

UnitResult::UnitResult(const Unit& unit, std::uint32_t replicates)
    : unit_(unit),
      replicates_(replicates),
      slots_(std::min(replicates, unit.num_samples)),
      sums_(static_cast<std::size_t>(unit.width) * static_cast<std::size_t>(unit.height) * slots_) {
}

void UnitResult::add_sample(int x, int y, std::uint32_t sample, Xyz value) {
    ++health_.samples;
    const double lowest = std::min({value.x, value.y, value.z});
    const double total = value.x + value.y + value.z;
    if (std::isnan(total) || std::isnan(lowest))
        return reject(x, y, sample, "nan", health_.rejected_nan);
    if (std::isinf(total)) return reject(x, y, sample, "infinite", health_.rejected_infinite);
    if (lowest < 0) return reject(x, y, sample, "negative", health_.rejected_negative);
    ReplicateSum& pixel = sums_[index(x, y, (sample - unit_.first_sample) % replicates_)];
    pixel.sum += value;
    ++pixel.count;
}

void UnitResult::reject(int x, int y, std::uint32_t sample, std::string_view kind,
                        std::uint64_t& counter) {
    ++counter;
    if (health_.rejected.size() < kMaxRejectedKept)
        health_.rejected.push_back({x, y, sample, std::string(kind)});
}

}  // namespace bouguer::renderer
