// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/film.h"

namespace bouguer::renderer {

Film::Film(Crop area, std::uint32_t replicates)
    : area_(area),
      replicates_(replicates),
      pixels_(static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height)),
      sums_(pixels_.size() * replicates) {}

void Film::merge(const UnitResult& result) {
    const Unit& unit = result.unit();
    for (int y = unit.y; y < unit.y + unit.height; ++y) {
        for (int x = unit.x; x < unit.x + unit.width; ++x) {
            const std::size_t i =
                static_cast<std::size_t>(y - area_.y) * static_cast<std::size_t>(area_.width) +
                static_cast<std::size_t>(x - area_.x);
            for (std::uint32_t slot = 0; slot < result.slots(); ++slot) {
                const ReplicateSum& from = result.at(x, y, slot);
                pixels_[i].sum += from.sum;
                pixels_[i].count += from.count;
                Replicate& to = sums_[i * replicates_ + result.replicate_of(slot)];
                to.sum[0] += static_cast<float>(from.sum.x);
                to.sum[1] += static_cast<float>(from.sum.y);
                to.sum[2] += static_cast<float>(from.sum.z);
                to.count += from.count;
            }
        }
    }
}

std::vector<float> Film::mean_xyz() const {
    std::vector<float> xyz;
    xyz.reserve(3 * pixels_.size());
    for (const Pixel& pixel : pixels_) {
        const Xyz mean = pixel.mean();
        for (const double v : {mean.x, mean.y, mean.z}) xyz.push_back(static_cast<float>(v));
    }
    return xyz;
}

}  // namespace bouguer::renderer
