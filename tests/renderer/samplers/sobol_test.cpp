// SPDX-License-Identifier: Apache-2.0
#include "renderer/samplers/sobol.h"

#include <gtest/gtest.h>

#include <array>

#include "renderer/core/hash.h"
#include "renderer/samplers/pixel_sampler.h"

namespace bouguer::renderer {
namespace {

// A (0,2)-net in base 2: the first 16 points have one in every elementary interval 2^-a x 2^-b with
// a + b = 4, scrambled or not.
TEST(ScrambledSobol, IsAZeroTwoNet) {
    for (std::uint64_t scramble = 1; scramble < 20; ++scramble) {
        for (int a = 0; a <= 4; ++a) {
            const int across = 1 << a;
            const int down = 16 / across;
            std::array<int, 16> count{};
            for (std::uint32_t i = 0; i < 16; ++i) {
                const Vec2 p = scrambled_sobol(i, mix(scramble));
                ++count[static_cast<std::size_t>(static_cast<int>(p.x * across) * down +
                                                 static_cast<int>(p.y * down))];
            }
            for (const int c : count) EXPECT_EQ(c, 1);
        }
    }
}

// One point each of 2^16 scramblings: mean 1/2 with standard error 1/sqrt(12 N) = 0.0011, tested at
// 5 of them; correlation of the coordinates 0 with standard error 1/sqrt(N) = 0.0039, likewise.
TEST(ScrambledSobol, ScramblingsAreUniformAndIndependent) {
    constexpr int kN = 1 << 16;
    double x = 0;
    double y = 0;
    double xy = 0;
    for (int i = 0; i < kN; ++i) {
        const Vec2 p = scrambled_sobol(0, hash(i));
        x += p.x;
        y += p.y;
        xy += (p.x - 0.5) * (p.y - 0.5) * 12;
    }
    EXPECT_NEAR(x / kN, 0.5, 0.0056);
    EXPECT_NEAR(y / kN, 0.5, 0.0056);
    EXPECT_NEAR(xy / kN, 0, 0.0195);
}

TEST(PixelSampler, IsAPureFunctionOfItsCoordinates) {
    EXPECT_EQ(PixelSampler(1, 2, 3, 4, 16).get_2d(5), PixelSampler(1, 2, 3, 4, 16).get_2d(5));
    const Vec2 base = PixelSampler(1, 2, 3, 4, 16).get_2d(5);
    EXPECT_NE(PixelSampler(9, 2, 3, 4, 16).get_2d(5), base);
    EXPECT_NE(PixelSampler(1, 3, 2, 4, 16).get_2d(5), base);
    EXPECT_NE(PixelSampler(1, 2, 3, 20, 16).get_2d(5), base);
    EXPECT_NE(PixelSampler(1, 2, 3, 4, 16).get_2d(6), base);
}

// Samples 3, 19, 35, 51 are the first four points of replicate 3: one in every quarter of the
// square.
TEST(PixelSampler, DealsSamplesToReplicatesInTurn) {
    std::array<int, 4> count{};
    for (std::uint32_t s = 3; s < 64; s += 16) {
        const Vec2 p = PixelSampler(7, 0, 0, s, 16).get_2d(0);
        ++count[static_cast<std::size_t>(2 * static_cast<int>(p.x * 2) +
                                         static_cast<int>(p.y * 2))];
    }
    for (const int c : count) EXPECT_EQ(c, 1);
}

}  // namespace
}  // namespace bouguer::renderer
