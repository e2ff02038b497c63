// SPDX-License-Identifier: Apache-2.0
// What is valid and probably not meant.
#include "api/scene_warnings.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/job_document.h"
#include "tests/support/named_bytes.h"

namespace bouguer::api {
namespace {

using nlohmann::json;

/// A glass ball in a lamp's light: nothing to warn of.
json scene() {
    return json::parse(R"({"format": "bouguer-scene/1",
        "camera": {"type": "perspective", "from": [0, 0, 9], "at": [0, 0, 0], "fov_deg": 30},
        "materials": {"glass": {"type": "hall", "k_sr": 0.1, "k_st": 0.9, "ior": 1.5}},
        "objects": [{"name": "ball", "material": "glass",
                     "shape": {"type": "sphere", "center": [0, 0, 0], "radius": 1}}],
        "lights": [{"type": "point", "position": [0, 2, 0], "intensity": 1}]})");
}

json object(const char* name, const char* material, json shape) {
    return {{"name", name}, {"material", material}, {"shape", std::move(shape)}};
}

const json kDisk{{"type", "disk"}, {"center", {0, -2, 0}}, {"normal", {0, 1, 0}}, {"radius", 1}};

/// "pointer code" of every warning.
std::vector<std::string> warned(const json& document) {
    const auto job = parse_job(document.dump(), Limits{}, tests::NoAssets{});
    if (!job) return {job.error().message};
    std::vector<std::string> all;
    for (const Warning& w : job->warnings.listed()) {
        EXPECT_FALSE(w.detail.empty());
        EXPECT_FALSE(w.advice.empty());
        all.push_back(w.pointer + " " + w.code);
    }
    return all;
}

using Texts = std::vector<std::string>;

TEST(SceneWarnings, SayNothingOfAGoodScene) { EXPECT_EQ(warned(scene()), Texts{}); }

TEST(SceneWarnings, NameWhatNothingUses) {
    json s = scene();
    s["materials"]["spare"] = {{"type", "hall"}, {"k_sr", 0.5}};
    s["spectra"]["red"] = 0.5;
    s["textures"]["squares"] = {{"type", "checker"}, {"a", 0.1}, {"b", 0.9}};
    EXPECT_EQ(warned(s), (Texts{"/textures/squares unused-texture", "/spectra/red unused-spectrum",
                                "/materials/spare unused-material"}));
}

// k_sr F_sr + k_st F_st at one wavelength, not the sum of the shares alone.
TEST(SceneWarnings, NameSharesAboveTheWhole) {
    json s = scene();
    s["materials"]["glass"]["k_sr"] = 0.2;
    EXPECT_EQ(warned(s), Texts{"/materials/glass gains-energy"});
    s["materials"]["glass"]["reflectance"] = 0.5;
    EXPECT_EQ(warned(s), Texts{}) << "0.2 x 0.5 + 0.9";
    s["materials"]["glass"] = {{"type", "phong"}, {"k_d", 0.7}, {"k_s", 0.7}};
    EXPECT_EQ(warned(s), Texts{"/materials/glass gains-energy"});
    s["materials"]["glass"] = {{"type", "hall"}, {"k_sr", 0.9}, {"n", 0}};
    EXPECT_EQ(warned(s), Texts{"/materials/glass gains-energy"}) << "the lobe holds twice 0.9";
}

TEST(SceneWarnings, NameSheetsWhoseInsideCountsForNothing) {
    json s = scene();
    s["objects"].push_back(object("film", "glass", kDisk));
    EXPECT_EQ(warned(s), Texts{"/objects/1 sheet-without-inside"});
    s["materials"]["glass"].erase("ior");
    EXPECT_EQ(warned(s), Texts{});
    s["materials"]["glass"]["absorption"] = {{"transmittance", 0.5}};
    EXPECT_EQ(warned(s), Texts{"/objects/1 sheet-without-inside"});
}

// Of two bodies at one priority the first counts: the other, inside, is not there.
TEST(SceneWarnings, NameBodiesHiddenInOthers) {
    json s = scene();
    s["objects"].push_back(
        object("bubble", "glass", {{"type", "sphere"}, {"center", {0, 0, 0.2}}, {"radius", 0.4}}));
    EXPECT_EQ(warned(s), Texts{"/objects/1 body-hidden"});
    s["objects"][1]["priority"] = 1;
    EXPECT_EQ(warned(s), Texts{});
    s["objects"][1].erase("priority");
    s["materials"]["air"] = {{"type", "hall"}, {"k_st", 1}, {"priority", 2}};
    s["objects"][1]["material"] = "air";
    EXPECT_EQ(warned(s), Texts{}) << "the priority of the material";
    s["objects"][1]["priority"] = 0;
    EXPECT_EQ(warned(s), Texts{"/objects/1 body-hidden"}) << "the object's replaces it";
}

TEST(SceneWarnings, NamePrioritiesOfWhatIsOpaque) {
    json s = scene();
    s["materials"]["wall"] = {{"type", "hall"}, {"k_sr", 1}};
    s["objects"].push_back(object("wall", "wall", kDisk));
    s["objects"][1]["priority"] = 3;
    EXPECT_EQ(warned(s), Texts{"/objects/1 priority-without-effect"});
}

// 0.9 a unit through 2 units is seen; 1e-8 a unit is 37 in optical depth.
TEST(SceneWarnings, NameAbsorptionThatLeavesNothing) {
    json s = scene();
    s["materials"]["glass"]["absorption"] = {{"transmittance", 0.9}, {"thickness", 1}};
    EXPECT_EQ(warned(s), Texts{});
    s["materials"]["glass"]["absorption"] = {{"transmittance", 0.9}, {"thickness", 0.001}};
    EXPECT_EQ(warned(s), Texts{"/objects/0 absorbs-everything"});
}

// 1 W/sr at 2 m gives a white surface Y = 0.25: 22 stops from white at an exposure of 1e6.
TEST(SceneWarnings, NameLampsTenStopsOff) {
    json job{{"format", "bouguer-job/1"}, {"scene", scene()}};
    EXPECT_EQ(warned(job), Texts{}) << "without an exposure the renderer finds one";
    job["output"]["exposure"] = 4;
    EXPECT_EQ(warned(job), Texts{});
    job["output"]["exposure"] = 1e6;
    EXPECT_EQ(warned(job), Texts{"/scene/lights lamps-too-bright"});
    job["output"]["exposure"] = 1e-6;
    EXPECT_EQ(warned(job), Texts{"/scene/lights lamps-too-dark"});
}

TEST(SceneWarnings, NameWeightsAboveTheHemisphere) {
    json s = scene();
    s["materials"]["wall"] = {{"type", "hall"}, {"k_sr", 1}};
    s["objects"].push_back(object("wall", "wall", kDisk));
    s["ambient"] = {{"k_a", 0.1}, {"weights", {{"ball", 0.75}, {"wall", 0.5}}}};
    EXPECT_EQ(warned(s), Texts{"/ambient/weights ambient-above-one"});
}

TEST(SceneWarnings, AreBounded) {
    json s = scene();
    for (int i = 0; i < 150; ++i)
        s["materials"]["spare" + std::to_string(i)] = {{"type", "hall"}, {"k_sr", 0.5}};
    const auto job = parse_job(s.dump(), Limits{}, tests::NoAssets{});
    ASSERT_TRUE(job);
    EXPECT_EQ(job->warnings.count(), 150U);
    EXPECT_EQ(job->warnings.listed().size(), Warnings::kMostListed);
}

// Micrometres, metres and Angstrom: a table that would count as one number.
TEST(SceneWarnings, TablesInAnotherUnitAreRefused) {
    const std::vector<std::vector<double>> tables{
        {0.4, 0.55, 0.7}, {4e-7, 5.5e-7, 7e-7}, {4000, 5500, 7000}};
    for (const auto& table : tables) {
        json s = scene();
        s["materials"]["glass"]["reflectance"] = {{"wavelengths_nm", table},
                                                  {"values", {0.1, 0.5, 0.9}}};
        const auto job = parse_job(s.dump(), Limits{}, tests::NoAssets{});
        ASSERT_FALSE(job) << table[0];
        const Problem& problem = job.error().problems.at(0);
        EXPECT_EQ(problem.pointer, "/materials/glass/reflectance/wavelengths_nm");
        EXPECT_EQ(problem.code, "no-visible-sample");
        EXPECT_NE(problem.detail.find("; as "), std::string::npos) << problem.detail;
    }
    json s = scene();
    s["materials"]["glass"]["reflectance"] = {
        {"first_nm", 0.4}, {"step_nm", 0.1}, {"values", {0.1, 0.5, 0.9}}};
    EXPECT_FALSE(parse_job(s.dump(), Limits{}, tests::NoAssets{}));
}

}  // namespace
}  // namespace bouguer::api
