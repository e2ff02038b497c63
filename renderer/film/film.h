// SPDX-License-Identifier: Apache-2.0
// The accumulators of a render.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/film/unit_result.h"

namespace bouguer::renderer {

/// Keeps, a pixel, the sum of all samples in double and the sums of the independent replicates in
/// single precision (they serve the error estimate only). Merged a tile's units in the order of
/// their sample ranges, it holds the same bits for any number of threads. Not thread-safe.
class Film {
  public:
    /// Covers `area` of the picture; `replicates` >= 2.
    Film(Crop area, std::uint32_t replicates);

    /// `result` lies inside the area.
    void merge(const UnitResult& result);

    [[nodiscard]] const Crop& area() const { return area_; }
    [[nodiscard]] std::size_t num_pixels() const { return pixels_.size(); }
    [[nodiscard]] std::uint32_t replicates() const { return replicates_; }

    /// Means of all samples, [height][width][3]; 0 where every sample was rejected.
    [[nodiscard]] std::vector<float> mean_xyz() const;

    struct Pixel {
        Xyz sum;
        std::uint64_t count = 0;
        [[nodiscard]] Xyz mean() const {
            return count == 0 ? Xyz{} : sum * (1.0 / static_cast<double>(count));
        }
    };
    struct Replicate {
        std::array<float, 3> sum{};
        std::uint32_t count = 0;
    };
    [[nodiscard]] const Pixel& pixel(std::size_t i) const { return pixels_[i]; }
    /// The replicates of pixel `i`: replicates() of them.
    [[nodiscard]] const Replicate* replicates_of(std::size_t i) const {
        return &sums_[i * replicates_];
    }

    /// Bytes for an area of so many pixels.
    [[nodiscard]] static std::uint64_t memory_bytes(std::uint64_t pixels,
                                                    std::uint32_t replicates) {
        return pixels * (sizeof(Pixel) + replicates * sizeof(Replicate));
    }

  private:
    Crop area_;
    std::uint32_t replicates_;
    std::vector<Pixel> pixels_;
    std::vector<Replicate> sums_;
};

}  // namespace bouguer::renderer
