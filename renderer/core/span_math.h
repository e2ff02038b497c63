// SPDX-License-Identifier: Apache-2.0
// Arithmetic on the numbers that a path carries: arrays of floats, padded with zeros to whole
// lanes.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <vector>

namespace bouguer::renderer {

/// Eight floats that the compiler keeps in vector registers, whatever their width: plain loops over
/// float[8] are four times slower with GCC 12. Lane by lane, so the result does not depend on the
/// width of the machine.
using Float8 = float __attribute__((vector_size(32)));
inline constexpr std::size_t kLanes = 8;

/// `n` rounded up to whole lanes.
constexpr std::size_t padded(std::size_t n) { return (n + kLanes - 1) / kLanes * kLanes; }

/// A table of rows of `width` floats each, every row padded with zeros to whole lanes and aligned
/// for Float8. Rows stay where they are; the table is shared read-only by threads once filled.
class SpectralTable {
  public:
    explicit SpectralTable(std::size_t width) : blocks_(padded(width) / kLanes) {}

    /// Appends a row (at most `width` values; the rest is zero) and returns its number.
    std::size_t add(const std::vector<float>& values);
    [[nodiscard]] const Float8* row(std::size_t i) const { return data_.data() + i * blocks_; }
    [[nodiscard]] std::size_t blocks() const { return blocks_; }  ///< Float8s in a row
    [[nodiscard]] std::size_t rows() const { return data_.size() / blocks_; }

  private:
    std::size_t blocks_;
    std::vector<Float8> data_;
};

inline Float8 splat(float x) { return Float8{x, x, x, x, x, x, x, x}; }

/// e^x lane by lane for x <= 0, to 2 units in the last place; 0 below -87. [Cody and Waite 1980,
/// ch. 6: reduction by ln 2 in two parts; the polynomial is a Taylor series to the seventh power on
/// |r| <= ln(2)/2]
Float8 exp_nonpositive(Float8 x);

}  // namespace bouguer::renderer
