// SPDX-License-Identifier: Apache-2.0
#include "renderer/core/span_math.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "renderer/core/every_cpu.h"

namespace bouguer::renderer {

float leading_bits(double x) {
    const auto single = static_cast<float>(x);
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(single) & 0xFFFFF000U);
}

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
