// SPDX-License-Identifier: Apache-2.0
#include "renderer/core/attenuation.h"

#include <algorithm>
#include <cstdint>

#include "renderer/core/every_cpu.h"

namespace bouguer::renderer {
namespace {

using Int8 = std::int32_t __attribute__((vector_size(32)));
using Long8 = std::int64_t __attribute__((vector_size(64)));

/// e^(x + rest) lane by lane for x <= 0 and |rest| <= |x| / 1000. [Cody and Waite 1980, ch. 6:
/// reduction by ln 2 in two parts; the polynomial is a Taylor series to the seventh power, on
/// |r| <= 0.44]
[[gnu::always_inline]] inline Float8 exp_nonpositive(Float8 x, Float8 rest) {
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

[[gnu::always_inline]] inline Double8 splat_double(double x) { return Double8{} + x; }

[[gnu::always_inline]] inline Double8 widen(Float8 x) {
    return __builtin_convertvector(x, Double8);
}

/// e^x lane by lane for x <= 0, the same way: a Taylor series to the tenth power, on |r| <= 0.35.
[[gnu::always_inline]] inline Double8 exp_nonpositive(Double8 x) {
    constexpr double kLog2e = 1.4426950408889634;
    constexpr double kLn2High = 0.693147180369123816490;  // 32 bits
    constexpr double kLn2Low = 1.90821492927058770002e-10;

    const Double8 floor_at = splat_double(-708.0);
    const Double8 reduced = x < floor_at ? floor_at : x;
    const Int8 k = __builtin_convertvector(reduced * kLog2e - 0.5, Int8);
    const Double8 kf = __builtin_convertvector(k, Double8);
    const Double8 r = (reduced - kf * kLn2High) - kf * kLn2Low;
    Double8 p = splat_double(1.0 / 3628800);
    for (const double c : {1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720, 1.0 / 120, 1.0 / 24,
                           1.0 / 6, 0.5, 1.0, 1.0}) {
        p = p * r + c;
    }
    const Long8 exponent = (__builtin_convertvector(k, Long8) + 1023) << 52;  // k >= -1022
    Double8 power;
    __builtin_memcpy(&power, &exponent, sizeof power);
    return x < floor_at ? splat_double(0) : p * power;
}

}  // namespace

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
void attenuate(Double8* transmittance, SplitRow log_t, double length, std::size_t blocks) {
    for (std::size_t i = 0; i < blocks; ++i)
        transmittance[i] *= exp_nonpositive((widen(log_t.high[i]) + widen(log_t.low[i])) * length);
}

BOUGUER_FOR_EVERY_CPU
void accumulate(Float8* sum, const DenseProduct& weight, double scale, const Float8* a,
                const Float8* b, std::size_t blocks) {
    for (std::size_t i = 0; i < blocks; ++i) {
        Double8 product = widen(weight.weight[i]) * scale;
        if (weight.dense != nullptr) product *= weight.dense[i];
        if (weight.tint != nullptr) product *= widen(weight.tint[i]);
        if (weight.dense_tint != nullptr) product *= weight.dense_tint[i];
        if (a != nullptr) product *= widen(a[i]);
        if (b != nullptr) product *= widen(b[i]);
        sum[i] += __builtin_convertvector(product, Float8);
    }
}

BOUGUER_FOR_EVERY_CPU
double largest(const Float8* row, const Double8* dense, std::size_t blocks) {
    Double8 most = splat_double(0);
    for (std::size_t i = 0; i < blocks; ++i) {
        const Double8 product = widen(row[i]) * dense[i];
        most = product > most ? product : most;
    }
    double peak = 0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) peak = std::max(peak, most[lane]);
    return peak;
}

}  // namespace bouguer::renderer
