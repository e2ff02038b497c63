// SPDX-License-Identifier: Apache-2.0
// The random numbers of one sample of one pixel.
#pragma once

#include <cstdint>

#include "renderer/core/hash.h"
#include "renderer/samplers/sobol.h"

namespace bouguer::renderer {

/// Randomness is a pure function of (seed, pixel, sample, dimension). Samples are dealt in turn to
/// `replicates` independent scramblings: sample s is point s / replicates of replicate s %
/// replicates. That is what the error estimate rests on.
class PixelSampler {
  public:
    PixelSampler(std::uint64_t seed, int x, int y, std::uint32_t sample, std::uint32_t replicates)
        : key_(hash(seed, x, y, sample % replicates)), index_(sample / replicates) {}

    /// A point of [0, 1)^2. Dimensions with different numbers are independent; any 64-bit number
    /// will do.
    [[nodiscard]] Vec2 get_2d(std::uint64_t dimension) const { return get_2d(dimension, 0, 1); }
    /// Point `i` of the `count` that every sample takes of this dimension; together they are as
    /// evenly spread as count times the samples.
    [[nodiscard]] Vec2 get_2d(std::uint64_t dimension, std::uint32_t i, std::uint32_t count) const {
        return scrambled_sobol(index_ * count + i, mix(key_ ^ mix(dimension + 1)));
    }

  private:
    std::uint64_t key_;
    std::uint32_t index_;
};

}  // namespace bouguer::renderer
