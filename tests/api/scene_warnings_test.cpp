// SPDX-License-Identifier: Apache-2.0
// What is valid and probably not meant.
#include "api/scene_warnings.h"

#include <gtest/gtest.h>

#include "tests/api/warning_testing.h"

namespace bouguer::api {
namespace {

using nlohmann::json;
using tests::Texts;
using tests::warned;

TEST(SceneWarnings, SayNothingOfAGoodScene) { EXPECT_EQ(warned(tests::good_scene()), Texts{}); }

TEST(SceneWarnings, NameWhatNothingUses) {
    json s = tests::good_scene();
    s["materials"]["spare"] = {{"type", "hall"}, {"k_sr", 0.5}};
    s["spectra"]["red"] = 0.5;
    s["textures"]["squares"] = {{"type", "checker"}, {"a", 0.1}, {"b", 0.9}};
    EXPECT_EQ(warned(s), (Texts{"/textures/squares unused-texture", "/spectra/red unused-spectrum",
                                "/materials/spare unused-material"}));
}

// k_sr F_sr + k_st F_st at one wavelength, not the sum of the shares alone.
TEST(SceneWarnings, NameSharesAboveTheWhole) {
    json s = tests::good_scene();
    s["materials"]["glass"]["k_sr"] = 0.2;
    EXPECT_EQ(warned(s), Texts{"/materials/glass gains-energy"});
    s["materials"]["glass"]["reflectance"] = 0.5;
    EXPECT_EQ(warned(s), Texts{}) << "0.2 x 0.5 + 0.9";
    s["materials"]["glass"] = {{"type", "phong"}, {"k_d", 0.7}, {"k_s", 0.7}};
    EXPECT_EQ(warned(s), Texts{"/materials/glass gains-energy"});
    s["materials"]["glass"] = {{"type", "hall"}, {"k_sr", 0.9}, {"n", 0}};
    EXPECT_EQ(warned(s), Texts{"/materials/glass gains-energy"}) << "the lobe holds twice 0.9";
}

// The specular share is what facets mirror of light from all sides: of n = 1.5 that is 0.092.
TEST(SceneWarnings, CountOfFacetsWhatTheyMirror) {
    json s = tests::good_scene();
    s["materials"]["glass"] = {{"type", "blinn"}, {"k_d", 0.9}, {"k_s", 1}, {"ior", 1.5}};
    EXPECT_EQ(warned(s), Texts{});
    s["materials"]["glass"]["k_d"] = 0.95;
    EXPECT_EQ(warned(s), Texts{"/materials/glass gains-energy"});
    s["materials"]["glass"] = {
        {"type", "hall_greenberg"}, {"k_dr", 0.1}, {"k_sr", 1}, {"k_st", 1}, {"ior", 1.5}};
    EXPECT_EQ(warned(s), Texts{"/materials/glass gains-energy"});
    s["materials"]["glass"].erase("k_dr");
    EXPECT_EQ(warned(s), Texts{}) << "Fresnel's equations divide the whole";
}

// Many of one code do not hide another.
TEST(SceneWarnings, AreBounded) {
    json s = tests::good_scene();
    for (int i = 0; i < 150; ++i)
        s["materials"]["spare" + std::to_string(i)] = {{"type", "hall"}, {"k_sr", 0.5}};
    s["camera"]["at"] = {0, 0, 99};
    const auto job = parse_job(s.dump(), Limits{}, tests::NoAssets{});
    ASSERT_TRUE(job);
    EXPECT_EQ(job->warnings.count(), 151U);
    EXPECT_EQ(job->warnings.listed().size(), Warnings::kMostOfOneCode + 1);
    EXPECT_EQ(job->warnings.listed().back().code, "camera-sees-nothing");
    EXPECT_EQ(job->warnings.about_unlisted().detail,
              "more than are listed: 130 of unused-material");
    Warnings twice = job->warnings;
    twice.add(job->warnings);
    EXPECT_EQ(twice.count(), 302U);
    EXPECT_EQ(twice.unlisted().at("unused-material"), 280U);
    EXPECT_EQ(twice.listed().size(), Warnings::kMostOfOneCode + 2);
}

}  // namespace
}  // namespace bouguer::api
