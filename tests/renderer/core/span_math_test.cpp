// SPDX-License-Identifier: Apache-2.0
#include "renderer/core/span_math.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bouguer::renderer {
namespace {

/// e^x as attenuate() finds it.
float exponential(float x) {
    Float8 weight = splat(1);
    const Float8 log_t = splat(x);
    attenuate(&weight, &log_t, 1, 1);
    return weight[3];
}

// Against the library's exponential of the same single-precision argument.
TEST(Attenuate, IsRightToAFewUnitsInTheLastPlace) {
    for (double x = -1e-8; x > -87; x *= 1.01) {
        const auto argument = static_cast<float>(x);
        const double expected = std::exp(static_cast<double>(argument));
        EXPECT_NEAR(exponential(argument) / expected, 1, 2.5e-7) << x;
    }
}

TEST(Attenuate, IsExactAtTheEnds) {
    EXPECT_EQ(exponential(0), 1);
    EXPECT_EQ(exponential(-0.0F), 1);
    EXPECT_EQ(exponential(-1e4F), 0);
    EXPECT_EQ(exponential(-INFINITY), 0);
}

TEST(SpectralTable, PadsRowsWithZeros) {
    SpectralTable table(9);
    EXPECT_EQ(table.blocks(), 2U);
    table.add(std::vector<float>(9, 1));
    const std::size_t second = table.add({5});
    EXPECT_EQ(second, 1U);
    EXPECT_EQ(table.row(0)[1][0], 1);
    EXPECT_EQ(table.row(0)[1][1], 0);
    EXPECT_EQ(table.row(1)[0][0], 5);
    EXPECT_EQ(table.row(1)[0][1], 0);
}

}  // namespace
}  // namespace bouguer::renderer
