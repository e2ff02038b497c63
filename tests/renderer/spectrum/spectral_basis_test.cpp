// SPDX-License-Identifier: Apache-2.0
#include "renderer/spectrum/spectral_basis.h"

#include <gtest/gtest.h>

#include "renderer/spectrum/display.h"
#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

void expect_near(Xyz a, Xyz b, double tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

/// What a path makes of a lamp seen through a factor.
Xyz seen(const SpectralBasis& basis, const Spectrum& lamp, const Spectrum& surface) {
    std::vector<float> radiance = basis.emission(lamp);
    const std::vector<float> factor = basis.factor(surface);
    for (std::size_t i = 0; i < radiance.size(); ++i) radiance[i] *= factor[i];
    return basis.to_xyz(radiance.data());
}

TEST(SpectralBasis, WavelengthsIntegrateAsXyzOfDoes) {
    const SpectrumPtr d65 = library_spectrum("D65");
    const SpectrumPtr green = *srgb_spectrum(0.1, 0.8, 0.2);
    for (const double step_nm : {1.0, 5.0, 7.0, 100.0}) {
        const SpectralBasis basis = SpectralBasis::wavelengths(step_nm);
        expect_near(seen(basis, *d65, *constant_spectrum(1)), xyz_of(*d65, step_nm), 1e-7);
        const Xyz expected = xyz_of_reflectance(*green, *d65, step_nm) * xyz_of(*d65, step_nm).y;
        expect_near(seen(basis, *d65, *green), expected, 1e-7);
    }
}

// to_xyz is the sum of value x weight, for sizes that fill its lanes and those that do not.
TEST(SpectralBasis, ToXyzIsTheWeightedSum) {
    for (const double step_nm : {5.0, 6.0, 47.0, 60.0, 94.0}) {
        const SpectralBasis basis = SpectralBasis::wavelengths(step_nm);
        ASSERT_EQ(basis.weights().size(), basis.size());
        std::vector<float> radiance(basis.size());
        Xyz expected;
        for (std::size_t i = 0; i < basis.size(); ++i) {
            radiance[i] = static_cast<float>(i * i % 7);
            const auto [x, y, z] = basis.weights()[i];
            expected += Xyz{x, y, z} * static_cast<double>(radiance[i]);
        }
        expect_near(basis.to_xyz(radiance.data()), expected, 1e-13);
    }
}

TEST(SpectralBasis, RgbOfAPerfectWhiteIsOne) {
    EXPECT_EQ(SpectralBasis::rgb().factor(*constant_spectrum(1)), (std::vector<float>{1, 1, 1}));
    const auto nearly = sampled_spectrum({360, 830}, {1, 1 - 1e-12});
    for (const float v : SpectralBasis::rgb().factor(**nearly)) EXPECT_NEAR(v, 1, 1e-7);
}

// A reflectance made from a display colour is that colour again.
TEST(SpectralBasis, RgbOfAnUpliftedColourIsTheColour) {
    const std::vector<float> found = SpectralBasis::rgb().factor(**srgb_spectrum(0.9, 0.4, 0.1));
    EXPECT_NEAR(found[0], srgb_decode(0.9), 1e-7);
    EXPECT_NEAR(found[1], srgb_decode(0.4), 1e-7);
    EXPECT_NEAR(found[2], srgb_decode(0.1), 1e-7);
}

// Relative D65 is 1 at 560 nm and has Y = 0.98890; the lamp's colour comes back through to_xyz.
TEST(SpectralBasis, RgbKeepsALampsColour) {
    const SpectralBasis basis = SpectralBasis::rgb();
    const SpectrumPtr d65 = library_spectrum("D65");
    for (const float v : basis.emission(*d65)) EXPECT_NEAR(v, 0.989, 1e-3);
    expect_near(basis.to_xyz(basis.emission(*d65).data()), xyz_of(*d65), 1e-6);
}

// Outside Rec.709: a negative component becomes 0 and the others stay.
TEST(SpectralBasis, RgbHasNoNegativeComponents) {
    const auto green = sampled_spectrum({500, 510, 530, 540}, {0, 1, 1, 0});
    const std::vector<float> rgb = SpectralBasis::rgb().factor(**green);
    EXPECT_EQ(rgb[0], 0);
    EXPECT_GT(rgb[1], 0);
    EXPECT_GE(rgb[2], 0);
}

TEST(SpectralBasis, GreyIsTheSamePictureAsWavelengths) {
    const SpectrumPtr d65 = library_spectrum("D65");
    const SpectrumPtr bright = scaled_spectrum(scaled_spectrum(d65, 4), 0.5);
    const SpectralBasis grey = SpectralBasis::grey(*bright, 5);
    EXPECT_EQ(grey.size(), 1U);
    EXPECT_EQ(grey.factor(*constant_spectrum(0.25)), std::vector<float>{0.25});
    EXPECT_EQ(grey.emission(*bright), std::vector<float>{2});
    EXPECT_EQ(grey.emission(*scaled_spectrum(d65, 3)), std::vector<float>{3});
    expect_near(seen(grey, *bright, *constant_spectrum(0.25)),
                seen(SpectralBasis::wavelengths(5), *bright, *constant_spectrum(0.25)), 1e-7);
}

// All constants are multiples of one: two lamps of equal energy have one colour.
TEST(SpectralBasis, GreyKnowsConstantLamps) {
    const SpectrumPtr lamp = constant_spectrum(2);
    const SpectralBasis grey = SpectralBasis::grey(*lamp, 5);
    EXPECT_EQ(grey.emission(*lamp), std::vector<float>{2});
    EXPECT_EQ(grey.emission(*constant_spectrum(7)), std::vector<float>{7});
    EXPECT_EQ(grey.emission(*constant_spectrum(0)), std::vector<float>{0});
}

}  // namespace
}  // namespace bouguer::renderer
