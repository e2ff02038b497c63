// SPDX-License-Identifier: Apache-2.0
// Textures that are computed: chequerboard and grid.
#include <gtest/gtest.h>

#include "renderer/spectrum/spectra.h"
#include "renderer/textures/checker_texture.h"
#include "renderer/textures/grid_texture.h"

namespace bouguer::renderer {
namespace {

const TextureWeights kFirst{1, 0, 0}, kSecond{0, 1, 0};

/// The mean over the middles of n x n cells of the unit square.
TextureWeights counted_mean(const Texture& texture, int n) {
    TextureWeights sum{};
    for (int i = 0; i < n * n; ++i) {
        const auto weights = texture.at({(i % n + 0.5) / n, (i / n + 0.5) / n});
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weights[k];
    }
    for (float& s : sum) s /= static_cast<float>(n) * static_cast<float>(n);
    return sum;
}

TEST(CheckerTexture, IsTwoByTwoSquares) {
    const auto a = constant_spectrum(0.2), b = constant_spectrum(0.8);
    const TexturePtr checker = checker_texture(a, b, {});
    EXPECT_EQ(checker->spectra(), (std::vector{a, b}));
    EXPECT_EQ(checker->at({0.1, 0.1}), kFirst);
    EXPECT_EQ(checker->at({0.6, 0.1}), kSecond);
    EXPECT_EQ(checker->at({0.1, 0.6}), kSecond);
    EXPECT_EQ(checker->at({0.6, 0.6}), kFirst);
    EXPECT_EQ(checker->at({-0.1, 0.1}), kSecond);  // the squares go on below 0
    EXPECT_EQ(checker->mean(), counted_mean(*checker, 8));
}

TEST(CheckerTexture, FollowsItsMapping) {
    const TexturePtr checker =
        checker_texture(constant_spectrum(0), constant_spectrum(1), {{2, 1}, {0, 0}, 0});
    EXPECT_EQ(checker->at({0.3, 0.1}), kSecond);
    EXPECT_EQ(checker->at({0.6, 0.1}), kFirst);
}

TEST(GridTexture, HasLinesOnTheBorders) {
    const TexturePtr grid = grid_texture(constant_spectrum(0), constant_spectrum(1), 0.25, {});
    EXPECT_EQ(grid->at({0.5, 0.5}), kSecond);
    EXPECT_EQ(grid->at({0.12, 0.5}), kFirst);
    EXPECT_EQ(grid->at({0.13, 0.5}), kSecond);
    EXPECT_EQ(grid->at({0.88, 0.5}), kFirst);
    EXPECT_EQ(grid->at({0.87, 0.5}), kSecond);
    EXPECT_EQ(grid->at({0.5, 0.99}), kFirst);
    EXPECT_EQ(grid->mean(), counted_mean(*grid, 16));  // ground: 0.75 x 0.75
}

TEST(GridTexture, MayBeAllLineOrNone) {
    const auto white = constant_spectrum(1), black = constant_spectrum(0);
    EXPECT_EQ(grid_texture(black, white, 0, {})->at({0, 0}), kSecond);
    EXPECT_EQ(grid_texture(black, white, 1, {})->at({0.5, 0.5}), kFirst);
    EXPECT_EQ(grid_texture(black, white, 0, {})->mean(), kSecond);
    EXPECT_EQ(grid_texture(black, white, 1, {})->mean(), kFirst);
}

}  // namespace
}  // namespace bouguer::renderer
