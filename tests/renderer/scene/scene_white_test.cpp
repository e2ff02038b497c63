// SPDX-License-Identifier: Apache-2.0
#include "renderer/scene/scene_white.h"

#include <gtest/gtest.h>

#include "renderer/spectrum/spectra.h"

namespace bouguer::renderer {
namespace {

const SpectrumPtr kA = library_spectrum("A"), kD65 = library_spectrum("D65");

SceneDescription lit_by(std::vector<SpectrumPtr> lamps) {
    SceneDescription scene;
    for (SpectrumPtr& spectrum : lamps) scene.lights.emplace_back(PointLight{{}, spectrum});
    return scene;
}

// Illuminant A is (0.44758, 0.40745) [CIE 15:2018, table T.3], in 1 nm steps too.
TEST(SceneWhite, IsThatOfTheLightHoweverBright) {
    const auto white = scene_white(lit_by({kA, scaled_spectrum(kA, 1e-9)}));
    ASSERT_TRUE(white);
    EXPECT_NEAR(white->x, 0.44758, 2e-5);
    EXPECT_NEAR(white->y, 0.40745, 2e-5);
}

TEST(SceneWhite, IsNoneWhereLightsDifferOrAreNot) {
    EXPECT_FALSE(scene_white(lit_by({})));
    EXPECT_FALSE(scene_white(lit_by({kA, kD65})));
    EXPECT_FALSE(scene_white(lit_by({constant_spectrum(0)})));
    EXPECT_TRUE(scene_white(lit_by({constant_spectrum(0), nullptr, kA})));
}

TEST(SceneWhite, SeesEveryKindOfLight) {
    SceneDescription scene = lit_by({kA});
    scene.lights.emplace_back(DirectionalLight{{0, -1, 0}, kD65});
    EXPECT_FALSE(scene_white(scene));
    scene = lit_by({kA});
    scene.environment = ConstantEnvironment{kD65};
    EXPECT_FALSE(scene_white(scene));
    scene = lit_by({kA});
    scene.ambient = AmbientDescription{0.3, HemisphereWeights{}, kD65};
    EXPECT_FALSE(scene_white(scene));
    scene = lit_by({kA});
    scene.materials.push_back({"lamp", HallMaterial{}, kD65});
    EXPECT_TRUE(scene_white(scene)) << "no object is of this material";
    scene.objects.emplace_back();
    EXPECT_FALSE(scene_white(scene));
    scene.objects.clear();
    scene.ambient = AmbientDescription{};
    scene.ambient->illuminant = nullptr;  // then it is the lamps' light
    EXPECT_TRUE(scene_white(scene));
}

}  // namespace
}  // namespace bouguer::renderer
