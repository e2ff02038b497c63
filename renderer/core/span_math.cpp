// SPDX-License-Identifier: Apache-2.0
#include "renderer/core/span_math.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "renderer/core/every_cpu.h"

namespace bouguer::renderer {
namespace {

/// The 12 leading bits of x: what is left of the 24 of a float when the others are cut off.
float leading_bits(double x) {
    const auto single = static_cast<float>(x);
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(single) & 0xFFFFF000U);
}

/// e^(x + rest) lane by lane for x <= 0 and |rest| <= |x| / 1000. [Cody and Waite 1980, ch. 6:
/// reduction by ln 2 in two parts; the polynomial is a Taylor series to the seventh power, on
/// |r| <= 0.44]
[[gnu::always_inline]] inline Float8 exp_nonpositive(Float8 x, Float8 rest) {
    using Int8 = std::int32_t __attribute__((vector_size(32)));
    constexpr float kLog2e = 1.44269504F;
    constexpr float kLn2High = 0.693359375F;  // 9 bits: its product with |k| < 128 is exact
    constexpr float kLn2Low = -2.12194440e-4F;

    const Float8 floor_at = splat(-87.0F);
    const Float8 reduced = x < floor_at ? floor_at : x;
    const Int8 k = __builtin_convertvector(reduced * kLog2e - 0.5F, Int8);  // rounds: x <= 0
    const Float8 kf = __builtin_convertvector(k, Float8);
    const Float8 r = ((reduced - kf * kLn2High) - kf * kLn2Low) + rest;
    Float8 p = splat(1.0F / 5040.0F);
    for (const float c :
         {1.0F / 720.0F, 1.0F / 120.0F, 1.0F / 24.0F, 1.0F / 6.0F, 0.5F, 1.0F, 1.0F}) {
        p = p * r + c;
    }
    const Int8 exponent = (k + 127) << 23;  // 2^k, normal because k >= -126
    Float8 power;
    __builtin_memcpy(&power, &exponent, sizeof power);
    return x < floor_at ? splat(0) : p * power;
}

}  // namespace

std::size_t SpectralTable::add(const std::vector<float>& values) {
    const std::size_t number = rows();
    data_.resize(data_.size() + blocks_, splat(0));
    auto* row = reinterpret_cast<float*>(data_.data() + number * blocks_);
    std::copy_n(values.begin(), std::min(values.size(), blocks_ * kLanes), row);
    return number;
}

std::size_t SpectralTable::add_split(const std::vector<double>& values) {
    std::vector<float> high(values.size()), low(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        high[i] = leading_bits(values[i]);
        low[i] = static_cast<float>(values[i] - static_cast<double>(high[i]));
    }
    const std::size_t number = add(high);
    add(low);
    return number;
}

BOUGUER_FOR_EVERY_CPU
void attenuate(Float8* weight, SplitRow log_t, double length, std::size_t blocks) {
    const float high = leading_bits(length);
    const auto low = static_cast<float>(length - static_cast<double>(high));
    const auto all = static_cast<float>(length);
    for (std::size_t i = 0; i < blocks; ++i) {
        const Float8 exact = log_t.high[i] * high;
        const Float8 rest = log_t.high[i] * low + log_t.low[i] * all;
        weight[i] *= exp_nonpositive(exact, rest);
    }
}

BOUGUER_FOR_EVERY_CPU
float largest(const Float8* row, std::size_t blocks) {
    Float8 most = splat(0);
    for (std::size_t i = 0; i < blocks; ++i) most = row[i] > most ? row[i] : most;
    float peak = 0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) peak = std::max(peak, most[lane]);
    return peak;
}

BOUGUER_FOR_EVERY_CPU
void multiply(Float8* row, float scale, const Float8* factor, std::size_t blocks) {
    for (std::size_t i = 0; i < blocks; ++i) row[i] *= scale * factor[i];
}

BOUGUER_FOR_EVERY_CPU
void accumulate(Float8* sum, float scale, const Float8* a, std::size_t blocks) {
    for (std::size_t i = 0; i < blocks; ++i) sum[i] += scale * a[i];
}

BOUGUER_FOR_EVERY_CPU
void accumulate(Float8* sum, const Float8* weight, float scale, const Float8* a, const Float8* b,
                const Float8* c, std::size_t blocks) {
    if (b == nullptr) {
        for (std::size_t i = 0; i < blocks; ++i) sum[i] += weight[i] * scale * a[i];
    } else if (c == nullptr) {
        for (std::size_t i = 0; i < blocks; ++i) sum[i] += weight[i] * scale * (a[i] * b[i]);
    } else {
        for (std::size_t i = 0; i < blocks; ++i) sum[i] += weight[i] * scale * (a[i] * b[i] * c[i]);
    }
}

BOUGUER_FOR_EVERY_CPU
float blend(Float8* to, const Float8* from, float ka, const Float8* a, float kb, const Float8* b,
            std::size_t blocks) {
    Float8 largest = splat(0);
    for (std::size_t i = 0; i < blocks; ++i) {
        to[i] = from[i] * (kb == 0 ? ka * a[i] : ka * a[i] + kb * b[i]);
        largest = to[i] > largest ? to[i] : largest;
    }
    float peak = 0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) peak = std::max(peak, largest[lane]);
    return peak;
}

}  // namespace bouguer::renderer
