// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/hall_material.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace bouguer::renderer {
namespace {

TEST(CosinePower, IsThePowerOfTheCosine) {
    EXPECT_EQ(cosine_power(0.3, 0), 1);
    EXPECT_EQ(cosine_power(0.5, 1), 0.5F);
    EXPECT_NEAR(cosine_power(0.9, 20), 0.12157665459056929, 1e-8);  // 0.9^20
    EXPECT_NEAR(cosine_power(0.9, 2.5), 0.76843346, 1e-7);          // 0.81 sqrt(0.9)
    EXPECT_NEAR(cosine_power(0.999999, 1e6), 0.36787926, 1e-7);     // (1 - 1e-6)^1e6
    EXPECT_EQ(cosine_power(1, 1e6), 1);
}

class BindHall : public testing::Test {
  protected:
    const SpectralBasis basis_ = SpectralBasis::wavelengths(5);
    SpectralTable table_{basis_.size()};
};

// Internal transmittance 0.81 at a thickness of 2 units: ln 0.9 a unit. Nothing comes through t =
// 0, everything through t = 1.
TEST_F(BindHall, TakesTheLogarithmPerUnit) {
    const auto log_of = [&](double t, double thickness) {
        HallMaterial m = test::clear(1.5);
        m.absorption = test::absorbing(t, thickness);
        const SplitRow row = table_.split_row(bind(m, basis_, table_).absorption->log_t);
        return row.high[0][0] + row.low[0][0];
    };
    EXPECT_NEAR(log_of(0.81, 2), -0.105360516, 1e-7);
    EXPECT_EQ(log_of(1, 1), 0);
    EXPECT_EQ(log_of(0, 1), -1e30F);
    EXPECT_EQ(log_of(0.5, 1e-300), -1e30F) << "no overflow";
}

TEST_F(BindHall, GivesNeighboursTheirPower) {
    HallMaterial m = test::matt(0.5);
    m.n = 3;
    const Surface s = bind(m, basis_, table_);
    EXPECT_EQ(table_.row(s.neighbour_reflectance)[0][0], 0.125F);
    EXPECT_EQ(table_.row(s.neighbour_transmittance)[0][0], 0) << "opaque";
    EXPECT_FALSE(s.transmits);
    EXPECT_FALSE(s.mirror);
}

}  // namespace
}  // namespace bouguer::renderer
