// SPDX-License-Identifier: Apache-2.0
// Bouguer's law on the numbers that a path carries, with the logarithms of transmittances in
// double.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/core/span_math.h"

namespace bouguer::renderer {

/// Eight doubles side by side, as Float8.
using Double8 = double __attribute__((vector_size(64)));
using Double8Vector = std::vector<Double8, CacheLineAllocator<Double8>>;

/// What stands for the logarithm of a transmittance of 0.
inline constexpr double kBlack = -1e30;

/// To this optical depth, e^-80 = 2e-35, single precision holds a throughput with all its digits.
inline constexpr double kSingleDepth = 80;

/// weight *= e^(log_t * length): Bouguer's law along a path. log_t <= 0, length >= 0. Right to 4e-7
/// of the result whatever the exponent: it is not rounded to single precision, where an optical
/// depth of 50 would cost 4e-6. 0 below e^-87.
void attenuate(Float8* weight, SplitRow log_t, double length, std::size_t blocks);

/// The same in double: right to 1e-8 of the result, 0 below e^-708.
void attenuate(Double8* transmittance, SplitRow log_t, double length, std::size_t blocks);

/// A product of rows that single precision cannot hold. A null row stands for ones.
struct DenseProduct {
    const Float8* weight;
    const Double8* dense = nullptr;
    const Float8* tint = nullptr;
    const Double8* dense_tint = nullptr;
};

/// sum += scale * weight * a * b, rounded when the product is complete. a and b may be null, too.
void accumulate(Float8* sum, const DenseProduct& weight, double scale, const Float8* a,
                const Float8* b, std::size_t blocks);

/// The largest of the products of two rows, at least 0.
[[nodiscard]] double largest(const Float8* row, const Double8* dense, std::size_t blocks);

}  // namespace bouguer::renderer
