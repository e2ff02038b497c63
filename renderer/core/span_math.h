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

/// Allocates on cache lines. Needed: without it a Float8 is aligned as the baseline instruction set
/// wants it, which is less than what the wider ones do.
template <class T>
struct CacheLineAllocator {
    using value_type = T;
    static constexpr std::align_val_t kAlignment{64};
    CacheLineAllocator() = default;
    template <class U>
    explicit CacheLineAllocator(const CacheLineAllocator<U>&) {}
    T* allocate(std::size_t n) {
        return static_cast<T*>(::operator new(n * sizeof(T), kAlignment));
    }
    void deallocate(T* p, std::size_t) { ::operator delete(p, kAlignment); }
    bool operator==(const CacheLineAllocator&) const { return true; }
};
using Float8Vector = std::vector<Float8, CacheLineAllocator<Float8>>;

/// The 12 leading bits of x: what is left of the 24 of a float when the others are cut off.
[[nodiscard]] float leading_bits(double x);

/// Numbers as sums: `high` has 12 bits, so that the product of two such numbers is exact; `low` is
/// what is missing.
struct SplitRow {
    const Float8* high;
    const Float8* low;
};

/// A table of rows of `width` floats each, every row padded with zeros to whole lanes and aligned
/// for Float8. Rows stay where they are; the table is shared read-only by threads once filled.
class SpectralTable {
  public:
    explicit SpectralTable(std::size_t width) : blocks_(padded(width) / kLanes) {}

    /// Appends a row (at most `width` values; the rest is zero) and returns its number.
    std::size_t add(const std::vector<float>& values);
    /// Appends `values` as two rows whose sum has some 36 bits, and returns the number of the
    /// first: for numbers of which single precision is not enough. split_row() reads them.
    std::size_t add_split(const std::vector<double>& values);
    [[nodiscard]] const Float8* row(std::size_t i) const { return data_.data() + i * blocks_; }
    [[nodiscard]] SplitRow split_row(std::size_t i) const { return {row(i), row(i + 1)}; }
    [[nodiscard]] std::size_t blocks() const { return blocks_; }  ///< Float8s in a row
    [[nodiscard]] std::size_t rows() const { return data_.size() / blocks_; }

  private:
    std::size_t blocks_;
    Float8Vector data_;
};

[[gnu::always_inline]] inline Float8 splat(float x) { return Float8{x, x, x, x, x, x, x, x}; }

// The loops of the shading, on rows of `blocks` Float8s each. Compiled for several instruction sets
// and chosen when the program starts; the arithmetic is lane by lane and never contracted, so all
// give the same bits.

/// The largest value of a row, at least 0.
[[nodiscard]] float largest(const Float8* row, std::size_t blocks);

/// row *= scale * factor
void multiply(Float8* row, float scale, const Float8* factor, std::size_t blocks);

/// sum += scale * a
void accumulate(Float8* sum, float scale, const Float8* a, std::size_t blocks);

/// sum += weight * scale * a, times b and c where they are not null.
void accumulate(Float8* sum, const Float8* weight, float scale, const Float8* a, const Float8* b,
                const Float8* c, std::size_t blocks);

/// to = from * (ka * a + kb * b); b is not read when kb is 0. Returns the largest value of `to`, at
/// least 0.
float blend(Float8* to, const Float8* from, float ka, const Float8* a, float kb, const Float8* b,
            std::size_t blocks);

}  // namespace bouguer::renderer
