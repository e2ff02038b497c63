// SPDX-License-Identifier: Apache-2.0
#include "renderer/core/span_math.h"

#include <algorithm>
#include <cstdint>

namespace bouguer::renderer {

std::size_t SpectralTable::add(const std::vector<float>& values) {
    const std::size_t number = rows();
    data_.resize(data_.size() + blocks_, splat(0));
    auto* row = reinterpret_cast<float*>(data_.data() + number * blocks_);
    std::copy_n(values.begin(), std::min(values.size(), blocks_ * kLanes), row);
    return number;
}

Float8 exp_nonpositive(Float8 x) {
    using Int8 = std::int32_t __attribute__((vector_size(32)));
    constexpr float kLog2e = 1.44269504F;
    constexpr float kLn2High = 0.693359375F;  // 9 bits: its product with |k| < 128 is exact
    constexpr float kLn2Low = -2.12194440e-4F;

    const Float8 floor_at = splat(-87.0F);
    const Float8 reduced = x < floor_at ? floor_at : x;
    const Int8 k = __builtin_convertvector(reduced * kLog2e - 0.5F, Int8);  // rounds: x <= 0
    const Float8 kf = __builtin_convertvector(k, Float8);
    const Float8 r = (reduced - kf * kLn2High) - kf * kLn2Low;
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

}  // namespace bouguer::renderer
