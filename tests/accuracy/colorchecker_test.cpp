// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/colorchecker.h"

#include <gtest/gtest.h>

#include "renderer/settings.h"

namespace bouguer::test {
namespace {

using namespace renderer;

class ColorCheckerUnder : public testing::TestWithParam<const char*> {};

// Lit straight on, a patch has the radiance reflectance x illuminant, so its colour needs no
// renderer. At 1 nm both use the same sum: what remains is the single precision of a path.
TEST_P(ColorCheckerUnder, IsRenderedAsItsSpectraSay) {
    const auto patches = render_colorchecker(GetParam(), 1);
    ASSERT_EQ(patches.size(), 24U);
    for (const PatchColour& patch : patches) EXPECT_LT(patch.delta_e(), 1e-4) << patch.name;
}

// What the default spacing costs is a tenth of what can just be seen, and the most of it is 0.04.
TEST_P(ColorCheckerUnder, IsCloseAtTheDefaultSpacing) {
    const auto patches = render_colorchecker(GetParam(), RenderSettings{}.wavelength_step_nm);
    EXPECT_LT(worst_delta_e(patches), 0.1);
}

INSTANTIATE_TEST_SUITE_P(Lights, ColorCheckerUnder, testing::Values("D65", "D50", "A"),
                         [](const auto& light) { return std::string(light.param); });

// BabelColor publishes these spectra's colours, too. What remains is a quarter of what can just be
// seen: x, y and Y stand there with four digits, and between samples 10 nm apart our spectra are
// straight lines where theirs are sums over the samples alone (0.04 to 0.1).
TEST(ColorChecker, HasTheColoursThatTheSpectraArePublishedWith) {
    const auto charts = published_charts();
    ASSERT_EQ(charts.size(), 3U);
    const auto patches = render_colorchecker("D50", 1);
    for (std::size_t i = 0; i < patches.size(); ++i)
        EXPECT_LT(delta_e_2000(patches[i].rendered, charts[0].patches[i]), 0.25) << patches[i].name;
}

}  // namespace
}  // namespace bouguer::test
