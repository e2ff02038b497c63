// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/orientation.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace bouguer::renderer {
namespace {

/// A sum without rounding, as parts that do not overlap, the smallest first.
class ExactSum {
  public:
    void add_product(Real a, Real b) {
        const Real product = a * b;
        add(std::fma(a, b, -product));
        add(product);
    }
    /// Of the same sign as the sum; zero only when it is.
    [[nodiscard]] Real largest_part() const {
        for (std::size_t i = count_; i > 0; --i) {
            if (parts_[i - 1] != 0) return parts_[i - 1];
        }
        return 0;
    }

  private:
    /// Grow-Expansion, by Knuth's sum of two.
    void add(Real x) {
        for (std::size_t i = 0; i < count_; ++i) {
            const Real sum = x + parts_[i];
            const Real virtual_part = sum - x;
            parts_[i] = (x - (sum - virtual_part)) + (parts_[i] - virtual_part);
            x = sum;
        }
        parts_[count_++] = x;
    }

    std::array<Real, 12> parts_{};
    std::size_t count_ = 0;
};

Real exactly(Vec2 a, Vec2 b, Vec2 c) {
    ExactSum sum;
    sum.add_product(a.x, b.y);
    sum.add_product(-a.x, c.y);
    sum.add_product(-c.x, b.y);
    sum.add_product(-a.y, b.x);
    sum.add_product(a.y, c.x);
    sum.add_product(c.y, b.x);
    return sum.largest_part();
}

}  // namespace

Real orientation(Vec2 a, Vec2 b, Vec2 c) {
    constexpr Real kHalfUlp = 0x1p-53;
    constexpr Real kBound = (3 + 16 * kHalfUlp) * kHalfUlp;  // Shewchuk's ccwerrboundA
    const Real left = (a.x - c.x) * (b.y - c.y);
    const Real right = (a.y - c.y) * (b.x - c.x);
    const Real area = left - right;
    if ((left > 0) != (right > 0) || left == 0 || right == 0) return area;
    if (std::abs(area) > kBound * std::abs(left + right)) return area;
    return exactly(a, b, c);
}

}  // namespace bouguer::renderer
