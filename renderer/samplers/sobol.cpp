// SPDX-License-Identifier: Apache-2.0
#include "renderer/samplers/sobol.h"

#include "renderer/core/hash.h"

namespace bouguer::renderer {
namespace {

constexpr std::uint32_t reverse_bits(std::uint32_t x) {
    x = (x << 16U) | (x >> 16U);
    x = ((x & 0x00ff00ffU) << 8U) | ((x & 0xff00ff00U) >> 8U);
    x = ((x & 0x0f0f0f0fU) << 4U) | ((x & 0xf0f0f0f0U) >> 4U);
    x = ((x & 0x33333333U) << 2U) | ((x & 0xccccccccU) >> 2U);
    return ((x & 0x55555555U) << 1U) | ((x & 0xaaaaaaaaU) >> 1U);
}

/// A permutation in which every bit is flipped depending on the bits above it only: an Owen
/// scramble of the reversed word. [Laine and Karras 2011, §3.1; constants of Vegdahl 2021]
constexpr std::uint32_t scramble_upwards(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeaU;
    x += seed;
    x *= (seed >> 16U) | 1U;
    x ^= x * 0x05526c56U;
    return x ^ (x * 0x53a22864U);
}

constexpr std::uint32_t owen_scramble(std::uint32_t x, std::uint32_t seed) {
    return reverse_bits(scramble_upwards(reverse_bits(x), seed));
}

/// Second coordinate of the Sobol' sequence: its direction numbers are the rows of Pascal's
/// triangle modulo 2.
constexpr std::uint32_t sobol_second(std::uint32_t index) {
    std::uint32_t bits = 0;
    for (std::uint32_t direction = 1U << 31U; index != 0;
         index >>= 1U, direction ^= direction >> 1U) {
        if ((index & 1U) != 0) bits ^= direction;
    }
    return bits;
}

constexpr double to_unit(std::uint32_t bits) { return bits * 0x1p-32; }

}  // namespace

Vec2 scrambled_sobol(std::uint32_t index, std::uint64_t scramble) {
    const std::uint64_t second = mix(scramble + 0x9e3779b97f4a7c15ULL);
    const std::uint32_t shuffled = owen_scramble(index, static_cast<std::uint32_t>(scramble));
    // The first coordinate is the radical inverse: the index with its bits reversed.
    return {
        to_unit(owen_scramble(reverse_bits(shuffled), static_cast<std::uint32_t>(scramble >> 32U))),
        to_unit(owen_scramble(sobol_second(shuffled), static_cast<std::uint32_t>(second)))};
}

}  // namespace bouguer::renderer
