// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/spectrum_notes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

TEST(SpectrumNotes, KeepTheWorstAndCountAll) {
    SpectrumNoteList notes;
    EXPECT_EQ(notes.largest(), 0);
    for (int i = 0; i < 50; ++i) notes.add(std::to_string(i), i % 25);
    EXPECT_EQ(notes.count(), 50U);
    ASSERT_EQ(notes.worst().size(), SpectrumNoteList::kMostKept);
    EXPECT_EQ(notes.worst()[0], (SpectrumNote{"24", 24}));
    EXPECT_EQ(notes.worst()[1], (SpectrumNote{"49", 24}));
    EXPECT_EQ(notes.worst()[19], (SpectrumNote{"40", 15}));
}

// Of 300 to 900 nm at one height, 60 below 360 and 70 above 830: 130 of 600.
TEST(ShareOutsideRange, IsThatOfTheLengthsForAConstant) {
    EXPECT_NEAR(share_outside_range(*constant_spectrum(3), 300, 900), 130.0 / 600, 1e-12);
    EXPECT_EQ(share_outside_range(*constant_spectrum(3), 360, 830), 0);
    EXPECT_EQ(share_outside_range(*constant_spectrum(3), 900, 1000), 1);
    EXPECT_EQ(share_outside_range(*constant_spectrum(0), 300, 900), 0);
}

// A triangle from 0 at 730 to 1 at 830 and 0 at 930 nm: half. Samples 0.1 nm apart change nothing.
TEST(ShareOutsideRange, IsThatOfTheSamples) {
    const auto triangle = *sampled_spectrum({730, 830, 930}, {0, 1, 0});
    EXPECT_NEAR(share_outside_range(*triangle, 730, 930), 0.5, 1e-4);
    std::vector<double> values(2001);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = 1 - std::abs(static_cast<double>(i) - 1000) / 1000;
    const auto fine = *regular_spectrum(730, 0.1, values);
    EXPECT_NEAR(share_outside_range(*fine, 730, 930), 0.5, 1e-3);
}

// The normal distribution: 15.8655 % lies beyond one sigma on one side. The rule's own error is
// h^2 / 24 times the slope there, 4e-6 for steps of 0.4 nm.
TEST(ShareOutsideRange, IsThatOfABell) {
    const double sigma_nm = 20, fwhm_nm = sigma_nm * std::sqrt(8 * std::log(2.0));
    const auto bell = *gaussian_spectrum(830 - sigma_nm, fwhm_nm, 1);
    EXPECT_NEAR(share_outside_range(*bell, 810 - 6 * sigma_nm, 810 + 6 * sigma_nm),
                0.5 * std::erfc(1 / std::sqrt(2.0)), 1e-5);
}

}  // namespace
}  // namespace bouguer::renderer
