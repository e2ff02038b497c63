// SPDX-License-Identifier: Apache-2.0
#include "renderer/core/attenuation.h"

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

/// The same in double.
double attenuated_in_double(double log_t, double length) {
    SpectralTable table(1);
    const std::size_t row = table.add_split({log_t});
    Double8 weight = Double8{} + 1.0;
    attenuate(&weight, table.split_row(row), length, 1);
    return weight[0];
}

TEST(AttenuateInDouble, GoesDownToWhatDoubleHolds) {
    for (double length = 1e-9; length < 1e12; length *= 77) {
        for (double x = -1e-12; x > -707; x *= 1.05) {
            EXPECT_NEAR(attenuated_in_double(x / length, length) / std::exp(x), 1, 2e-8)
                << x << " " << length;
        }
    }
}

TEST(AttenuateInDouble, IsExactAtTheEnds) {
    EXPECT_EQ(attenuated_in_double(0, 1e30), 1);
    EXPECT_EQ(attenuated_in_double(-1, 0), 1);
    EXPECT_EQ(attenuated_in_double(-1e4, 1), 0);
    EXPECT_EQ(attenuated_in_double(kBlack, 1e30), 0);
    EXPECT_EQ(attenuated_in_double(kBlack, 1e-20), 0);
    EXPECT_EQ(attenuated_in_double(kBlack, 0), 1);
}

// 2^-100 * 2^-200 * 2^250 * 3: neither of the first two products is a float.
TEST(AccumulateDense, RoundsWhenTheProductIsComplete) {
    const Float8 weight = splat(0x1p-100F), emission = splat(0x1p100F), colour = splat(3);
    const Double8 dense = Double8{} + 0x1p-200;
    Float8 sum = splat(1);
    accumulate(&sum, {&weight, &dense}, 0x1p200, &emission, &colour, 1);
    EXPECT_EQ(sum[0], 4);
    accumulate(&sum, {&weight, &dense, &emission, &dense}, 0x1p300, &emission, nullptr, 1);
    EXPECT_EQ(sum[7], 5);
}

TEST(LargestDense, IsThatOfTheProducts) {
    const Float8 row{1, 0, 0.5F, 0, 0, 0, 0, 0};
    const Double8 dense{1e-200, 1, 1e-100, 1, 1, 1, 1, 1};
    EXPECT_DOUBLE_EQ(largest(&row, &dense, 1), 0.5e-100);
}

}  // namespace
}  // namespace bouguer::renderer
