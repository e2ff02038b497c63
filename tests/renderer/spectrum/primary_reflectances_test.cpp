// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/primary_reflectances.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/spectrum/colour.h"
#include "renderer/spectrum/smooth_reflectance.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

SpectrumPtr mixed(const std::array<double, 3>& rgb) {
    const auto& [red, green, blue] = srgb_primary_reflectances();
    const auto sum_of = [](SpectrumPtr a, SpectrumPtr b, double share) {
        std::vector<double> values;
        for (double nm = kLambdaMin_nm; nm <= kLambdaMax_nm; ++nm)
            values.push_back(a->at(nm) + share * b->at(nm));
        return regular_spectrum(kLambdaMin_nm, 1, std::move(values)).value();
    };
    return sum_of(sum_of(scaled_spectrum(red, rgb[0]), green, rgb[1]), blue, rgb[2]);
}

// The property that makes every mixture a reflectance.
TEST(PrimaryReflectances, AddUpToOne) {
    const auto& [red, green, blue] = srgb_primary_reflectances();
    for (double nm = 300; nm <= 900; nm += 2.5) {
        EXPECT_NEAR(red->at(nm) + green->at(nm) + blue->at(nm), 1, 3e-10) << nm;
        EXPECT_GT(std::min({red->at(nm), green->at(nm), blue->at(nm)}), 0) << nm;
    }
}

// A published row, 380 nm: 0.327457414, 0.331861713, 0.340680792.
TEST(PrimaryReflectances, AreNearlyThePublishedOnes) {
    const auto& [red, green, blue] = srgb_primary_reflectances();
    EXPECT_NEAR(red->at(380), 0.327457414, 2e-3);
    EXPECT_NEAR(green->at(380), 0.331861713, 2e-3);
    EXPECT_NEAR(blue->at(380), 0.340680792, 2e-3);
    EXPECT_EQ(red->at(360), red->at(380));
    EXPECT_EQ(blue->at(830), blue->at(780));
}

// The whole cube of colours in steps of a quarter: what a mixture looks like under D65.
TEST(PrimaryReflectances, GiveColoursBack) {
    double worst = 0;
    for (int i = 0; i < 125; ++i) {
        const std::array rgb{i % 5 / 4.0, i / 5 % 5 / 4.0, i / 25 / 4.0};
        worst = std::max(worst, delta_e_2000(rgb, rec709_of_reflectance(*mixed(rgb))));
    }
    RecordProperty("worst_delta_e_2000_e-12", std::to_string(1e12 * worst));
    EXPECT_LT(worst, 1e-9);
}

}  // namespace
}  // namespace bouguer::renderer
