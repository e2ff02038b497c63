// SPDX-License-Identifier: Apache-2.0
// How the numbers of a file become light.
#pragma once

#include <cstdint>

namespace bouguer::renderer {

/// A curve from the numbers of a file, 1 the largest, to light, 1 the white's.
struct TransferCurve {
    enum class Kind : std::uint8_t {
        Unstated,  ///< the file does not say
        Linear,
        Srgb,   ///< [IEC 61966-2-1]
        Power,  ///< number^exponent
        Bt709,  ///< the inverse of the camera's curve [ITU-T H.273, table 3, values 1, 6, 14, 15]
        Smpte240,  ///< likewise [ibid., value 7]
    };
    Kind kind = Kind::Unstated;
    double exponent = 1;  ///< of Power

    /// Of a number >= 0. An unstated curve is that of sRGB.
    [[nodiscard]] double operator()(double number) const;
};

}  // namespace bouguer::renderer
