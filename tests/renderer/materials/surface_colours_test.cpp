// SPDX-License-Identifier: Apache-2.0
#include "renderer/materials/surface_colours.h"

#include <gtest/gtest.h>

#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

/// Weights u, v and 0.5 of three spectra; on average 0.1, 0.2, 0.4.
class ThreePart final : public Texture {
  public:
    [[nodiscard]] const std::vector<SpectrumPtr>& spectra() const override { return spectra_; }
    [[nodiscard]] TextureWeights at(Vec2 uv) const override {
        return {static_cast<float>(uv.x), static_cast<float>(uv.y), 0.5F};
    }
    [[nodiscard]] TextureWeights mean() const override { return {0.1F, 0.2F, 0.4F}; }

  private:
    std::vector<SpectrumPtr> spectra_{constant_spectrum(0.2), constant_spectrum(0.4),
                                      constant_spectrum(0.8)};
};

class Mixing : public testing::Test {
  protected:
    const SpectralBasis basis_ = SpectralBasis::wavelengths(5);
    SpectralTable table_{basis_.size()};
    const SurfaceSpectrum textured_{constant_spectrum(0.5), std::make_shared<ThreePart>()};
};

// 0.5 (0.3 0.2 + 0.6 0.4 + 0.5 0.8) = 0.35
TEST_F(Mixing, WeighsTheSpectraOfATexture) {
    const BoundSpectrum bound = bind_factor(textured_, basis_, table_);
    SurfaceColours colours(table_);
    colours.move_to({0.3, 0.6});
    const Float8* row = colours.row(bound, SurfaceColours::kFirst);
    EXPECT_NEAR(row[3][5], 0.35, 1e-6);
    colours.move_to({0, 0});
    EXPECT_NEAR(colours.row(bound, SurfaceColours::kSecond)[3][5], 0.2, 1e-6);
    EXPECT_NEAR(row[3][5], 0.35, 1e-6) << "another slot leaves it";
}

// The mean 0.5 (0.1 0.2 + 0.2 0.4 + 0.4 0.8) = 0.21, squared 0.0441
TEST_F(Mixing, GivesNeighboursThePowerOfTheMean) {
    EXPECT_NEAR(table_.row(bind_neighbour(true, textured_, 2, basis_, table_))[3][5], 0.0441, 1e-6);
    EXPECT_EQ(table_.row(bind_neighbour(false, textured_, 2, basis_, table_))[3][5], 0);
}

}  // namespace
}  // namespace bouguer::renderer
