// SPDX-License-Identifier: Apache-2.0
// Equation 1 against closed forms, from hardly anything absorbed to hardly anything left.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/hall_look.h"

namespace bouguer::renderer {
namespace {

using test::absorbing;
using test::clear;
using test::glass;
using test::in_environment;
using test::look;
using test::matt;
using test::SceneBuilder;
using test::Seen;
using test::slab;
using test::sun;

// The paper's example: 3 units of 0.9 a unit leave 0.9^3 = 0.729.
TEST(HallAbsorption, LeavesThePowerOfTheThickness) {
    const auto scene = in_environment().add(slab(3), glass(1, 0.9)).build();
    EXPECT_NEAR(look(*scene, {0.1, 0.2, 5}, {0.1, 0.2, -10}).y, 0.729, 1e-6);
}

// Three touching slabs of 1 are one of 3.
TEST(HallAbsorption, DoesNotCareForCutsThroughTheBody) {
    const auto scene = in_environment()
                           .add(Box{{-9, -9, -1}, {9, 9, 0}}, glass(1, 0.9))
                           .add(Box{{-9, -9, -2}, {9, 9, -1}}, glass(1, 0.9))
                           .add(Box{{-9, -9, -3}, {9, 9, -2}}, glass(1, 0.9))
                           .build();
    EXPECT_NEAR(look(*scene, {0.1, 0.2, 5}, {0.1, 0.2, -10}).y, 0.729, 2e-6);
}

// At 45 degrees the way through glass of 1.5 is 1/cos(asin(sin 45 / 1.5)) = 1.133893 times the
// thickness.
TEST(HallAbsorption, FollowsTheRefractedLength) {
    const auto scene = in_environment().add(slab(1), glass(1.5, 0.9)).build();
    EXPECT_NEAR(look(*scene, {0, 0, 5}, {5, 0, 0}).y, std::pow(0.9, 1.133893), 1e-6);
}

TEST(HallAbsorption, IsExactAtItsEnds) {
    EXPECT_EQ(look(*in_environment().add(slab(3), glass(1, 0)).build(), {0, 0, 5}, {0, 0, 0}).y, 0);
    EXPECT_NEAR(look(*in_environment().add(slab(3), glass(1, 1)).build(), {0, 0, 5}, {0, 0, 0}).y,
                1, 1e-6);
}

// A camera inside a body looks through what lies between it and the surface.
TEST(HallAbsorption, BeginsAtACameraInsideTheBody) {
    const auto scene = in_environment().add(Sphere{{0, 0, 0}, 3}, glass(1.5, 0.9)).build();
    const Seen seen = look(*scene, {0, 0, 0}, {0, 0, 1});
    EXPECT_NEAR(seen.y, 0.729, 1e-6);
    EXPECT_TRUE(seen.counters.lost_bodies.empty());
}

// A plane is a half-space: what is seen through it lies infinitely deep, and nothing of it comes
// that the body absorbs.
TEST(HallAbsorption, IsCompleteInAHalfSpace) {
    const auto through = [](double t) {
        const auto scene = in_environment().add(Plane{{0, 0, 0}, {0, 0, 1}}, glass(1.3, t)).build();
        return look(*scene, {0, 0, 5}, {0, 1, 0}).y;
    };
    EXPECT_EQ(through(0.99), 0);
    EXPECT_NEAR(through(1), 1, 1e-6);
}

/// What comes through `depth` units of glass with `transmittance` at a thickness of 1, from an
/// environment of `radiance`.
double through(double transmittance, Real depth, double radiance = 1) {
    const auto scene = in_environment(radiance).add(slab(depth), glass(1, transmittance)).build();
    return look(*scene, {0.1, 0.2, 5}, {0.1, 0.2, -10}).y;
}

// ln 0.99999993 = -7.0000002e-8: a million micrometres leave e^-0.07 = 0.93239. In single precision
// the transmittance is 1 - 5.96e-8, which leaves 0.942.
TEST(HallAbsorption, KeepsTransmittancesNearOne) {
    EXPECT_NEAR(through(0.99999993, 1e6), 0.932393805, 1e-6);
    EXPECT_NEAR(through(1 - 1e-9, 1e9), std::exp(-1), 1e-6);
    // What double itself leaves of 1 - 1e-12 is right to 6e-5.
    EXPECT_NEAR(through(1 - 1e-12, 1e12), std::exp(-1), 1e-4);
}

// 1e-300 a unit over a thousandth of it is 1e-0.3.
TEST(HallAbsorption, KeepsTransmittancesNearZero) {
    EXPECT_NEAR(through(1e-300, 1e-3), std::pow(10, -0.3), 1e-6);
    EXPECT_NEAR(through(1e-40, 0.1), 1e-4, 1e-9);
    EXPECT_EQ(through(0, 1e-3), 0);
}

// A transmittance sampled by wavelength, from 1e-300 to 1 - 1e-12 a unit, over a ten-thousandth and
// a million of it.
TEST(HallAbsorption, KeepsSampledTransmittances) {
    const auto seen = [](double low, double high, Real depth) {
        HallMaterial m = clear(1);
        m.absorption = {sampled_spectrum({360, 555, 555.001, 830}, {low, low, high, high}).value(),
                        1};
        return look(*in_environment().add(slab(depth), m).build(), {0.1, 0.2, 5}, {0.1, 0.2, -10})
            .y;
    };
    // Half of the light is below 555 nm or so: what is there is read off where the rest is black.
    const double below = seen(1, 0, 1), above = seen(0, 1, 1);
    EXPECT_NEAR(below + above, 1, 1e-2);
    EXPECT_NEAR(seen(1e-300, 1e-100, 1e-4),
                below * std::pow(10, -0.03) + above * std::pow(10, -0.01), 2e-3);
    EXPECT_NEAR(seen(1 - 1e-7, 1 - 2e-7, 1e6), below * std::exp(-0.1) + above * std::exp(-0.2),
                2e-3);
}

// e^-100 of 1e10, and of 1.
TEST(HallAbsorption, IsNotZeroBehindAnOpticalDepthOfAHundred) {
    EXPECT_NEAR(through(std::exp(-1), 100, 1e10) / (1e10 * std::exp(-100)), 1, 1e-5);
    EXPECT_NEAR(through(std::exp(-10), 9, 1) / std::exp(-90), 1, 1e-5);
    EXPECT_NEAR(through(std::exp(-1), 150, 1e30) / (1e30 * std::exp(-150)), 1, 1e-5);
    // Of one body after the other, each of which single precision would hold.
    const auto two = in_environment(1e30)
                         .add(Box{{-9, -9, -1}, {9, 9, 0}}, glass(1, std::exp(-60)))
                         .add(Box{{-9, -9, -3}, {9, 9, -2}}, glass(1, std::exp(-70)))
                         .build();
    EXPECT_NEAR(look(*two, {0.1, 0.2, 5}, {0.1, 0.2, -10}).y / (1e30 * std::exp(-130)), 1, 1e-5);
}

// What single precision holds of a ray's other wavelengths does not hide the dense ones: the lamp
// is blue, and the glass leaves e^-100 there and half of everything else.
TEST(HallAbsorption, KeepsTheOnlyWavelengthsThatAreLit) {
    HallMaterial m = clear(1);
    m.absorption = {
        sampled_spectrum({360, 500, 501, 830}, {std::exp(-100), std::exp(-100), 0.5, 0.5}).value(),
        1};
    SceneBuilder builder;
    builder.description.environment =
        ConstantEnvironment{sampled_spectrum({459, 460, 480, 481}, {0, 1e30, 1e30, 0}).value()};
    const double unfiltered =
        look(*builder.add(slab(1), clear(1)).build(), {0, 0.1, 5}, {0, 0, 0}).y;
    SceneBuilder filtered;
    filtered.description.environment = builder.description.environment;
    const double seen = look(*filtered.add(slab(1), m).build(), {0, 0.1, 5}, {0, 0, 0}).y;
    EXPECT_GT(unfiltered, 0);
    // Along a ray that leans by 0.1 in 5 the way is sqrt(1 + 0.02^2) long.
    EXPECT_NEAR(seen / unfiltered, std::exp(-100 * std::sqrt(1.0004)), 1e-4 * std::exp(-100));
}

// The light of a lamp comes down through two filters, and goes up through them to a camera above.
TEST(HallAbsorption, LetsLampsShineThroughDenseMatter) {
    const auto floor_lit = [](Real camera_height, double depth, double other_depth) {
        const auto scene = SceneBuilder()
                               .add(Plane{{0, 0, 0}, {0, 0, 1}}, matt(1))
                               .add(Box{{-9, -9, 1}, {9, 9, 2}}, glass(1, std::exp(-depth)))
                               .add(Box{{-9, -9, 3}, {9, 9, 4}}, glass(1, std::exp(-other_depth)))
                               .light(sun({0, 0, -1}, 1e30))
                               .build();
        return look(*scene, {0.1, 0.2, camera_height}, {0.1, 0.2, 0}).y / 1e30;
    };
    EXPECT_NEAR(floor_lit(9, 20, 45) / std::exp(-130), 1, 1e-5);
    EXPECT_NEAR(floor_lit(0.5, 60, 50) / std::exp(-110), 1, 1e-5);
    EXPECT_NEAR(floor_lit(2.5, 20, 90) / std::exp(-130), 1, 1e-5);
}

// What the depth limit cuts behind dense matter is booked by its true weight: e^-100.
TEST(HallAbsorption, BooksDenseRaysByTheirWeight) {
    const auto scene = in_environment(1e30).add(slab(1), glass(1, std::exp(-100))).build();
    RenderSettings settings = test::exact_settings();
    settings.max_depth = 1;
    const Seen seen = look(*scene, {0.1, 0.2, 5}, {0.1, 0.2, -10}, settings);
    EXPECT_EQ(seen.y, 0);
    EXPECT_NEAR(seen.counters.depth_throughput / std::exp(-100), 1, 1e-5);
    EXPECT_EQ(seen.counters.blackened_samples, 1U);
}

}  // namespace
}  // namespace bouguer::renderer
