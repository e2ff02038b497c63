// SPDX-License-Identifier: Apache-2.0
#include "renderer/core/span_math.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bouguer::renderer {
namespace {

/// e^(log_t * length) as attenuate() finds it.
float attenuated(double log_t, double length) {
    SpectralTable table(1);
    const std::size_t row = table.add_split({log_t});
    Float8 weight = splat(1);
    attenuate(&weight, table.split_row(row), length, 1);
    return weight[0];
}

// The error does not grow with the exponent, as it would by its rounding: 3e-8 of 87 is 2.6e-6.
TEST(Attenuate, IsRightToAFewUnitsInTheLastPlace) {
    for (double length = 1e-3; length < 1e3; length *= 7.7) {
        for (double x = -1e-8; x > -87; x *= 1.01) {
            const double expected = std::exp(x);
            EXPECT_NEAR(attenuated(x / length, length) / expected, 1, 4e-7) << x << " " << length;
        }
    }
}

TEST(Attenuate, IsExactAtTheEnds) {
    EXPECT_EQ(attenuated(0, 1), 1);
    EXPECT_EQ(attenuated(-1, 0), 1);
    EXPECT_EQ(attenuated(0, 1e30), 1);
    EXPECT_EQ(attenuated(-1e4, 1), 0);
    EXPECT_EQ(attenuated(-1e30, 1e30), 0);
    EXPECT_EQ(attenuated(-1e30, 1e-3), 0);
    EXPECT_EQ(attenuated(-1e30, 0), 1);
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
