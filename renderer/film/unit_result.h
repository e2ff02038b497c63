// SPDX-License-Identifier: Apache-2.0
// What one unit of work adds to the film, and the one door through which samples reach it.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "renderer/integrators/integrator.h"
#include "renderer/render.h"
#include "renderer/spectrum/colour.h"

namespace bouguer::renderer {

/// Sum of the samples of one replicate in one pixel.
struct ReplicateSum {
    Xyz sum;
    std::uint32_t count = 0;
};

/// Not thread-safe: each belongs to the thread that traces its unit.
class UnitResult {
  public:
    static constexpr std::size_t kMaxRejectedKept = 16;

    /// `replicates` of the whole render; only those that the unit's samples touch take memory.
    UnitResult(const Unit& unit, std::uint32_t replicates);

    /// The door. A sample that is NaN, infinite or negative in any of X, Y, Z is left out together
    /// with its weight, counted by kind and remembered for replay. `x`, `y`: pixel of the full
    /// resolution.
    void add_sample(int x, int y, std::uint32_t sample, Xyz value);

    [[nodiscard]] const Unit& unit() const { return unit_; }

    /// How many of its samples were traced, in the order in which the tracer takes them: where it
    /// goes on.
    std::size_t cursor = 0;
    [[nodiscard]] std::size_t num_samples() const {
        return static_cast<std::size_t>(unit_.width) * static_cast<std::size_t>(unit_.height) *
               unit_.num_samples;
    }
    [[nodiscard]] bool is_complete() const { return cursor == num_samples(); }

    /// Of the pixel (x, y) and the replicate that holds sample unit.first_sample + slot.
    [[nodiscard]] const ReplicateSum& at(int x, int y, std::uint32_t slot) const {
        return sums_[index(x, y, slot)];
    }
    [[nodiscard]] std::uint32_t slots() const { return slots_; }
    [[nodiscard]] std::uint32_t replicate_of(std::uint32_t slot) const {
        return (unit_.first_sample + slot) % replicates_;
    }
    [[nodiscard]] const Health& health() const { return health_; }

    TraceCounters counters;       ///< filled by the tracer
    std::uint64_t rays_told = 0;  ///< of counters.rays, kept by whoever shows progress

  private:
    [[nodiscard]] std::size_t index(int x, int y, std::uint32_t slot) const {
        return (static_cast<std::size_t>(y - unit_.y) * static_cast<std::size_t>(unit_.width) +
                static_cast<std::size_t>(x - unit_.x)) *
                   slots_ +
               slot;
    }
    void reject(int x, int y, std::uint32_t sample, std::string_view kind, std::uint64_t& counter);

    Unit unit_;
    std::uint32_t replicates_, slots_;
    std::vector<ReplicateSum> sums_;
    Health health_;
};

}  // namespace bouguer::renderer
