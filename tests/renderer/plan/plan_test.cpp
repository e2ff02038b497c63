// SPDX-License-Identifier: Apache-2.0
#include "renderer/plan/plan.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/render.h"
#include "tests/support/scenes.h"

namespace bouguer::renderer {
namespace {

using test::clear;
using test::matt;
using test::SceneBuilder;

bool needed(const Plan& plan, const std::string& feature) {
    const auto it = std::find_if(plan.items.begin(), plan.items.end(),
                                 [&](const PlanItem& i) { return i.feature == feature; });
    EXPECT_NE(it, plan.items.end()) << feature;
    EXPECT_FALSE(it->reason.empty());
    return it->needed;
}

TEST(Plan, LeavesOutWhatAGreyScenesDoesNotNeed) {
    const auto scene = SceneBuilder()
                           .add(Sphere{}, matt(0.5))
                           .light(PointLight{{0, 0, 5}, library_spectrum("D65")})
                           .build();
    const Plan plan = make_plan(*scene, {});
    for (const char* feature : {"transparency", "absorption", "ambient", "wavelengths",
                                "light selection", "environment"}) {
        EXPECT_FALSE(needed(plan, feature)) << feature;
    }
    EXPECT_EQ(plan.kernel, "hall<transparency=0,ambient=0>");
    EXPECT_EQ(plan.basis, "grey");
    EXPECT_EQ(plan.values_per_path, 1U);
}

TEST(Plan, NamesWhatIsNeeded) {
    HallMaterial glass = clear(1.5);
    glass.absorption = test::absorbing(0.9);
    SceneBuilder builder;
    builder.add(Sphere{}, glass)
        .light(PointLight{{0, 0, 5}, library_spectrum("D65")})
        .light(PointLight{{0, 5, 5}, library_spectrum("A")});
    builder.description.ambient = AmbientDescription{0.5, HemisphereWeights{}, nullptr};
    const Plan plan = make_plan(*builder.build(), {});
    for (const char* feature : {"transparency", "refraction", "absorption", "ambient",
                                "hemisphere rays", "wavelengths", "light selection"}) {
        EXPECT_TRUE(needed(plan, feature)) << feature;
    }
    EXPECT_EQ(plan.kernel, "hall<transparency=1,ambient=1>");
    EXPECT_EQ(plan.values_per_path, 95U);
}

// Lamps of one colour at different brightness are one colour; the shape of the spectrum sits in the
// weights.
TEST(Plan, SeesLampsThatAreMultiplesOfEachOther) {
    const auto d65 = library_spectrum("D65");
    SceneBuilder builder;
    builder.add(Sphere{}, matt(0.5))
        .light(PointLight{{0, 0, 5}, scaled_spectrum(d65, 2)})
        .light(PointLight{{0, 0, 9}, scaled_spectrum(d65, 3)});
    EXPECT_FALSE(analyse(*builder.build()).wavelengths);
    builder.light(PointLight{{0, 0, 9}, constant_spectrum(1)});
    EXPECT_TRUE(analyse(*builder.build()).wavelengths);
}

TEST(Plan, IgnoresMaterialsThatNoObjectUses) {
    SceneBuilder builder;
    builder.add(Sphere{}, matt(0.5)).light(PointLight{{0, 0, 5}, constant_spectrum(1)});
    builder.description.materials.push_back({"unused glass", clear(1.5)});
    EXPECT_FALSE(analyse(*builder.build()).transparency);
}

// Grey surfaces: the error is that of the illuminant's own quadrature. A at 1 nm against 1 nm:
// none.
TEST(QuadratureError, VanishesAtOneNanometre) {
    const auto scene = SceneBuilder()
                           .add(Sphere{}, matt(0.5))
                           .light(PointLight{{0, 0, 5}, library_spectrum("A")})
                           .build();
    EXPECT_EQ(quadrature_error(*scene, 1), 0);
    EXPECT_GT(quadrature_error(*scene, 40), quadrature_error(*scene, 5));
}

// The light of D65 on grey, seen by each observer, as spectrum and as one number: the colour is
// what the observer's own functions make of D65.
TEST(Plan, LetsEveryObserverSee) {
    const auto scene = SceneBuilder()
                           .add(Sphere{}, matt(0.5))
                           .light(PointLight{{0, 0, 5}, library_spectrum("D65")})
                           .build();
    for (const Observer& observer : observers()) {
        const Xyz own = xyz_of(*library_spectrum("D65"), 5, observer);
        for (const bool specialise : {false, true}) {
            RenderSettings settings;
            settings.observer = observer.name();
            settings.specialise = specialise;
            const SpectralBasis basis = choose_basis(*scene, analyse(*scene), settings);
            const Xyz seen = basis.to_xyz(basis.emission(*library_spectrum("D65")).data());
            EXPECT_NEAR(seen.x, own.x, 1e-6) << observer.name() << basis.name();
            EXPECT_NEAR(seen.y, own.y, 1e-6) << observer.name() << basis.name();
            EXPECT_NEAR(seen.z, own.z, 1e-6) << observer.name() << basis.name();
        }
    }
}

}  // namespace
}  // namespace bouguer::renderer
