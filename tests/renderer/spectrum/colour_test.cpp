// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/colour.h"

#include <gtest/gtest.h>

#include "renderer/spectrum/quadrature.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

void expect_near(Chromaticity found, Chromaticity expected, double tolerance) {
    EXPECT_NEAR(found.x, expected.x, tolerance);
    EXPECT_NEAR(found.y, expected.y, tolerance);
}

// CIE 15:2018, table of the illuminants' chromaticities for the 2-degree observer.
TEST(Colour, IlluminantsHaveTheirPublishedChromaticities) {
    expect_near(chromaticity(xyz_of(*library_spectrum("D65"))), {0.31272, 0.32903}, 1e-5);
    expect_near(chromaticity(xyz_of(*library_spectrum("A"))), {0.44758, 0.40745}, 1.5e-5);
    expect_near(chromaticity(xyz_of(*library_spectrum("D50"))), {0.34567, 0.35851}, 1.5e-5);
    expect_near(chromaticity(xyz_of(*library_spectrum("D55"))), {0.33243, 0.34744}, 1.5e-5);
    expect_near(chromaticity(xyz_of(*library_spectrum("D75"))), {0.29903, 0.31488}, 1.5e-5);
    expect_near(chromaticity(xyz_of(*library_spectrum("E"))), {1.0 / 3, 1.0 / 3}, 5e-5);
}

// A factor that does not depend on wavelength cannot move a chromaticity, by whatever quadrature.
TEST(Colour, AGreyCardUnderD65HasTheColourOfD65) {
    const SpectrumPtr d65 = library_spectrum("D65");
    const Chromaticity white = chromaticity(xyz_of(*d65, 1));
    for (const double step_nm : {1.0, 5.0})
        expect_near(chromaticity(xyz_of_reflectance(*constant_spectrum(0.18), *d65, step_nm)),
                    white, 1e-4);
    EXPECT_NEAR(xyz_of_reflectance(*constant_spectrum(0.18), *d65, 5).y, 0.18, 1e-12);
}

// What kYIntegral_nm is for: it is the table's own sum.
TEST(Colour, AConstantOfOneHasUnitLuminance) {
    EXPECT_NEAR(xyz_of(*constant_spectrum(1), 1).y, 1, 1e-9);
    EXPECT_NEAR(xyz_of(*constant_spectrum(1), 5).y, 1, 2e-6);
}

// The last node of 100 nm is 760: the next would lie past the end.
TEST(Colour, QuadratureStaysInTheRange) {
    EXPECT_EQ(quadrature(1).size(), 471U);
    EXPECT_EQ(quadrature(5).size(), 95U);
    EXPECT_EQ(quadrature(0.1).size(), 4701U);
    EXPECT_EQ(quadrature(0.1).back().lambda_nm, 830);
    EXPECT_EQ(quadrature(100).back().lambda_nm, 760);
}

// CIE 018:2019: y-bar(555) = 1; the row of 450 nm; halfway between rows the mean; nothing outside.
TEST(Colour, ObserverFollowsItsTable) {
    EXPECT_EQ(cie1931(555)[1], 1);
    EXPECT_EQ(cie1931(450), (std::array{0.3362, 0.038, 1.77211}));
    EXPECT_NEAR(cie1931(555.5)[1], (cie1931(555)[1] + cie1931(556)[1]) / 2, 1e-15);
    EXPECT_EQ(cie1931(830)[1], 4.5181e-7);
    EXPECT_EQ(cie1931(359.999)[1], 0);
    EXPECT_EQ(cie1931(830.001)[1], 0);
}

// IEC 61966-2-1 prints the matrix to four digits.
TEST(Colour, Rec709MatrixIsThatOfTheStandard) {
    const Matrix3 expected{
        {{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
    const Matrix3 product = xyz_to_rec709() * rec709_to_xyz();
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            EXPECT_NEAR(rec709_to_xyz()[i][j], expected[i][j], 6e-5);
            EXPECT_NEAR(product[i][j], i == j ? 1 : 0, 1e-14);
        }
}

TEST(Colour, BlackHasNoChromaticity) {
    EXPECT_EQ(chromaticity({}).x, 0);
    EXPECT_EQ(chromaticity({}).y, 0);
}

}  // namespace
}  // namespace bouguer::renderer
