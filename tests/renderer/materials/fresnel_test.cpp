// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/core/vec3.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

double at_angle(double degrees, double n, double k = 0) {
    return fresnel_reflectance(std::cos(degrees_to_radians(degrees)), n, k);
}

// Unpolarised, from air into n = 1.5: the mean of R_s and R_p, which at 45 degrees are .0920134 and
// .0084665.
TEST(Fresnel, OfGlass) {
    EXPECT_NEAR(at_angle(0, 1.5), 0.04, 1e-12);
    EXPECT_NEAR(at_angle(45, 1.5), (0.0920134 + 0.0084665) / 2, 1e-7);
    EXPECT_NEAR(at_angle(80, 1.5), 0.387704, 1e-6);
    EXPECT_NEAR(at_angle(89.9, 1.5), 0.989912, 1e-6);
    EXPECT_EQ(fresnel_reflectance(0, 1.5, 0), 1);
    // Brewster's angle: R_p is 0 and R_s = ((n^2 - 1) / (n^2 + 1))^2 = 0.147929.
    EXPECT_NEAR(at_angle(56.309932474, 1.5), 0.147928994 / 2, 1e-9);
}

TEST(Fresnel, OfLightThatComesOut) {
    EXPECT_NEAR(at_angle(0, 1 / 1.5), 0.04, 1e-12);
    EXPECT_LT(at_angle(41.80, 1 / 1.5), 1) << "the critical angle is 41.81031 degrees";
    EXPECT_EQ(at_angle(41.82, 1 / 1.5), 1);
    EXPECT_EQ(at_angle(89.9, 1 / 1.5), 1);
}

TEST(Fresnel, OfEqualIndicesIsNothingAtAnyAngle) {
    for (const double degrees : {0.0, 30.0, 89.0, 89.999}) EXPECT_EQ(at_angle(degrees, 1), 0);
    EXPECT_EQ(fresnel_reflectance(0, 1, 0), 0);
}

// ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2)
TEST(Fresnel, OfMetals) {
    EXPECT_NEAR(at_angle(0, 0.2, 3), 0.923372, 1e-6);
    EXPECT_NEAR(at_angle(0, 1, 1000), 0.999996, 1e-6);
    EXPECT_NEAR(at_angle(0, 1000, 1000), 0.998002, 1e-6);
    EXPECT_EQ(fresnel_reflectance(0, 0.2, 3), 1);
    EXPECT_NEAR(at_angle(60, 1.5, 1e-12), at_angle(60, 1.5), 1e-11) << "k -> 0 is a dielectric";
}

TEST(Fresnel, OfRowsIsThatOfEveryLane) {
    SpectralTable table(9);
    const std::vector<float> n{1.5F, 0.2F, 1, 0.05F, 1 / 1.5F, 100, 1.33F, 2.4F, 0.96F};
    const std::vector<float> k{0, 3, 0, 4.2F, 0, 100, 0, 0, 6.7F};
    const std::size_t rows[] = {table.add(n), table.add(k)};
    for (const double cosine : {1.0, 0.8, 0.5, 0.1, 1e-3, 0.0}) {
        Float8Vector to(table.blocks());
        fresnel_reflectances(to.data(), cosine, table.row(rows[0]), table.row(rows[1]),
                             table.blocks());
        for (std::size_t i = 0; i < n.size(); ++i) {
            const float lane = to[i / kLanes][i % kLanes];
            EXPECT_NEAR(lane, fresnel_reflectance(cosine, n[i], k[i]), 2e-6) << n[i] << " " << k[i];
        }
        for (std::size_t lane = 1; lane < kLanes; ++lane) EXPECT_TRUE(std::isfinite(to[1][lane]));
    }
}

// Gold at 650 nm reflects nearly all, at 450 nm little: published n + i k of 0.16 + 3.15 i or so
// against 1.4 + 1.9 i [Johnson and Christy 1972].
TEST(NormalReflectance, GivesMetalsTheirColour) {
    const auto gold = normal_reflectance(library_metal("Au"));
    EXPECT_GT(gold->at(650), 0.9);
    EXPECT_LT(gold->at(450), 0.5);
    EXPECT_TRUE(normal_reflectance({constant_spectrum(1.5), constant_spectrum(0)})->is_constant());
}

}  // namespace
}  // namespace bouguer::renderer
