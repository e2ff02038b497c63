// SPDX-License-Identifier: Apache-2.0
// Integer hashing: where all randomness comes from. Pure functions; the same on every machine.
#pragma once

#include <cstdint>

namespace bouguer::renderer {

/// A bijection of 64-bit words in which every input bit flips about half the output bits.
/// [Stafford 2011, "Better bit mixing", variant 13]
constexpr std::uint64_t mix(std::uint64_t x) {
    x ^= x >> 30U;
    x *= 0xbf58476d1ce4e5b9ULL;
    x ^= x >> 27U;
    x *= 0x94d049bb133111ebULL;
    return x ^ (x >> 31U);
}

/// Hash of a sequence of words; the order matters.
template <class... Words>
constexpr std::uint64_t hash(Words... words) {
    std::uint64_t h = 0x9e3779b97f4a7c15ULL;
    ((h = mix(h ^ (static_cast<std::uint64_t>(words) + 0x9e3779b97f4a7c15ULL))), ...);
    return h;
}

}  // namespace bouguer::renderer
