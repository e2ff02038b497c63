// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/observer.h"

#include <gtest/gtest.h>

#include "renderer/spectrum/colour.h"
#include "renderer/spectrum/spectra.h"
#include "renderer/spectrum/spectral_basis.h"

namespace bouguer::renderer {
namespace {

// CIE 15:2018: chromaticities of the illuminants for the 10-degree observer.
TEST(Observer, TenDegreesSeesTheIlluminantsAsPublished) {
    const Observer* wide = find_observer("cie1964-10");
    ASSERT_TRUE(wide);
    const auto d65 = chromaticity(xyz_of(*library_spectrum("D65"), 1, *wide));
    EXPECT_NEAR(d65.x, 0.31382, 2e-5);
    EXPECT_NEAR(d65.y, 0.33100, 2e-5);
    const auto a = chromaticity(xyz_of(*library_spectrum("A"), 1, *wide));
    EXPECT_NEAR(a.x, 0.45117, 2e-5);
    EXPECT_NEAR(a.y, 0.40594, 2e-5);
}

// Every observer is made so that equal energy has equal X, Y and Z, and is normalised to Y = 1.
TEST(Observer, EqualEnergyIsWhiteForAll) {
    EXPECT_EQ(observers().size(), 4U);
    for (const Observer& observer : observers()) {
        const Xyz white = xyz_of(*constant_spectrum(1), 1, observer);
        EXPECT_NEAR(white.y, 1, 1e-9) << observer.name();
        EXPECT_NEAR(white.x, 1, 4e-4) << observer.name();
        EXPECT_NEAR(white.z, 1, 4e-4) << observer.name();
        EXPECT_FALSE(observer.source().empty());
        EXPECT_EQ(observer.description().find("x-bar"), std::string_view::npos);
        EXPECT_EQ(find_observer(observer.name()), &observer);
    }
    EXPECT_EQ(find_observer("cie1931"), nullptr);
}

TEST(Observer, TheStandardOneIsThatOfTheConventions) {
    EXPECT_EQ(standard_observer().name(), "cie1931-2");
    EXPECT_NEAR(standard_observer().y_integral_nm(), kYIntegral_nm, 1e-7);
    EXPECT_EQ(standard_observer().at(555), cie1931(555));
}

TEST(Observer, IsTheChoiceOfABasis) {
    const Observer* wide = find_observer("cie1964-10");
    const SpectralBasis basis = SpectralBasis::wavelengths(5, *wide);
    const SpectrumPtr d65 = library_spectrum("D65");
    EXPECT_NEAR(basis.to_xyz(basis.emission(*d65).data()).z, xyz_of(*d65, 5, *wide).z, 1e-7);
}

}  // namespace
}  // namespace bouguer::renderer
