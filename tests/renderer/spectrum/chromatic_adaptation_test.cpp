// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/chromatic_adaptation.h"

#include <gtest/gtest.h>

namespace bouguer::renderer {
namespace {

constexpr Chromaticity kD65{0.31272, 0.32903}, kA{0.44758, 0.40745}, kD50{0.3457, 0.3585};
constexpr std::array kMethods{Adaptation::Bradford, Adaptation::Cat16};

std::array<double, 3> white(Chromaticity c) { return {c.x / c.y, 1, (1 - c.x - c.y) / c.y}; }

TEST(ChromaticAdaptation, TakesWhiteToWhite) {
    for (const Adaptation method : kMethods) {
        const auto found = adaptation_matrix(method, kA, kD65) * white(kA);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], white(kD65)[i], 1e-12);
    }
}

TEST(ChromaticAdaptation, NoneIsTheIdentityAndSoIsNoChange) {
    for (const Adaptation method : {Adaptation::None, Adaptation::Bradford, Adaptation::Cat16}) {
        const Matrix3 m = adaptation_matrix(method, kD65, kD65);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(m[i][j], i == j ? 1 : 0, 1e-12);
    }
    EXPECT_EQ(adaptation_matrix(Adaptation::None, kA, kD65)[0][1], 0);
}

TEST(ChromaticAdaptation, GoesBackAndForth) {
    for (const Adaptation method : kMethods) {
        const Matrix3 m = adaptation_matrix(method, kD65, kA) * adaptation_matrix(method, kA, kD65);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(m[i][j], i == j ? 1 : 0, 1e-12);
    }
}

// The published Bradford matrix from D65 to D50, as every ICC profile of an sRGB display has it.
TEST(ChromaticAdaptation, BradfordIsThatOfTheProfiles) {
    const Matrix3 m = adaptation_matrix(Adaptation::Bradford, {0.3127, 0.3290}, kD50);
    const Matrix3 expected{
        {{1.0479, 0.0229, -0.0502}, {0.0296, 0.9904, -0.0171}, {-0.0092, 0.0151, 0.7518}}};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(m[i][j], expected[i][j], 2e-4);
}

// Bradford's second response to light of 700 nm is -0.7502 x 0.7347 / 0.2653 + 1.7135 < 0: scaling
// it to that of a white would turn colours into their opposites.
TEST(ChromaticAdaptation, TakesOnlyForWhiteWhatAllConesSee) {
    for (const Adaptation method : kMethods) {
        EXPECT_TRUE(can_be_white(method, kA));
        EXPECT_TRUE(can_be_white(method, kD50));
        EXPECT_FALSE(can_be_white(method, {0.3, 0}));
        EXPECT_FALSE(can_be_white(method, {0.7, 0.1}));  // beyond the purples
    }
    EXPECT_FALSE(can_be_white(Adaptation::Bradford, {0.1566, 0.0177}));  // 450 nm
    EXPECT_TRUE(can_be_white(Adaptation::Cat16, {0.1566, 0.0177}));
    EXPECT_FALSE(can_be_white(Adaptation::Bradford, {0.7347, 0.2653}));
    EXPECT_TRUE(can_be_white(Adaptation::None, {0.7347, 0.2653}));
}

}  // namespace
}  // namespace bouguer::renderer
