// SPDX-License-Identifier: Apache-2.0
// Lamps that give nothing, too much or too little; cameras that see nothing.
#include "api/light_warnings.h"

#include <gtest/gtest.h>

#include "tests/api/warning_testing.h"

namespace bouguer::api {
namespace {

using nlohmann::json;
using tests::object;
using tests::sphere;
using tests::Texts;
using tests::warned;

const json kBox{{"type", "box"}, {"min", {-3, -3, -3}}, {"max", {3, 3, 3}}};

// 1 W/sr at 2 m gives a white surface Y = 0.25: 18 stops from white at an exposure of 1e6.
TEST(LightWarnings, NameLampsTenStopsOff) {
    json job{{"format", "bouguer-job/1"}, {"scene", tests::good_scene()}};
    EXPECT_EQ(warned(job), Texts{}) << "without an exposure the renderer finds one";
    job["output"]["exposure"] = 4;
    EXPECT_EQ(warned(job), Texts{});
    job["output"]["exposure"] = 1e6;
    EXPECT_EQ(warned(job), Texts{"/scene/lights lamps-too-bright"});
    job["output"]["exposure"] = 1e-6;
    EXPECT_EQ(warned(job), Texts{"/scene/lights lamps-too-dark"});
    job["scene"]["camera"]["at"] = {0, 2, 0};
    EXPECT_EQ(warned(job), Texts{}) << "it looks at the lamp itself";
    job["scene"]["camera"]["at"] = {0, 0, 0};
    job["scene"]["environment"] = {{"type", "constant"}, {"radiance", 1e6}};
    EXPECT_EQ(warned(job), Texts{}) << "the sky counts, too";
    job["scene"].erase("lights");
    job["output"]["exposure"] = 1;
    EXPECT_EQ(warned(job), Texts{"/scene/environment lamps-too-bright"});
}

TEST(LightWarnings, NameLampsThatGiveNothing) {
    json s = tests::good_scene();
    s["lights"].push_back({{"type", "directional"}, {"direction", {0, -1, 0}}, {"irradiance", 0}});
    EXPECT_EQ(warned(s), Texts{"/lights/1 lamp-without-light"});
    s["lights"][1]["irradiance"] = {{"line_nm", 1064}, {"width_nm", 0.1}, {"integral", 5}};
    EXPECT_EQ(warned(s), Texts{"/lights/1 lamp-without-light"});
    s["lights"][1]["irradiance"]["line_nm"] = 632.8;
    EXPECT_EQ(warned(s), Texts{}) << "a narrow line between whole nanometres";
}

TEST(LightWarnings, NameScenesWithoutLight) {
    json s = tests::good_scene();
    s.erase("lights");
    EXPECT_EQ(warned(s), Texts{" no-light"});
    s["materials"]["glass"]["emission"] = 0;
    EXPECT_EQ(warned(s), Texts{" no-light"});
    s["materials"]["glass"]["emission"] = 2;
    EXPECT_EQ(warned(s), Texts{});
    s["materials"]["glass"].erase("emission");
    s["environment"] = {{"type", "constant"}, {"radiance", 1}};
    EXPECT_EQ(warned(s), Texts{});
    json job{{"format", "bouguer-job/1"}, {"scene", s}};
    job["scene"].erase("environment");
    EXPECT_EQ(warned(job), Texts{"/scene no-light"});
}

TEST(LightWarnings, NameLampsInsideOpaqueBodies) {
    json s = tests::scene_with_wall();
    s["objects"].push_back(object("bulb", "wall", sphere(0, 2, 0, 0.1)));
    EXPECT_EQ(warned(s), Texts{"/lights/0 lamp-shut-in"});
    s["lights"][0]["position"] = {0, 2.1, 0};
    EXPECT_EQ(warned(s), Texts{}) << "on its surface";
    s["lights"][0]["position"] = {0, 2, 0};
    s["objects"][1]["material"] = "glass";
    s["materials"].erase("wall");
    EXPECT_EQ(warned(s), Texts{}) << "light goes through glass";
}

TEST(LightWarnings, NameNeighboursThatGiveBackMoreThanTheyGet) {
    json s = tests::scene_with_wall();
    s["objects"].push_back(object("wall", "wall", sphere(3, 0, 0, 1)));
    s["ambient"] = {{"k_a", 0.1}, {"weights", {{"ball", 0.75}, {"wall", 0.5}}}};
    EXPECT_EQ(warned(s), Texts{"/ambient/weights ambient-above-one"});
    s["ambient"] = {{"k_a", 1.5}, {"weights", "hemisphere"}};
    EXPECT_EQ(warned(s), Texts{"/ambient/k_a ambient-above-one"});
    s["ambient"]["illuminant"] = "D65";
    EXPECT_EQ(warned(s), Texts{});
}

// A line of 0.1 nm and a band of 0.1 nm beside it have nothing in common; in one step of 5 nm both
// are means. A lamp that is behind the band already is integrated as it is.
TEST(SpectralWarnings, NameNarrowColoursInNarrowLight) {
    const json line{{"line_nm", 550}, {"width_nm", 0.1}, {"integral", 1}};
    const json band{{"center_nm", 551}, {"fwhm_nm", 0.2}, {"peak", 0.9}};
    json s = tests::good_scene();
    s["lights"][0]["intensity"] = line;
    EXPECT_EQ(warned(s), Texts{}) << "white glass";
    s["materials"]["glass"]["transmittance"] = band;
    EXPECT_EQ(warned(s), Texts{"/materials/glass narrow-spectra-meet"});
    s["lights"][0]["intensity"] = "D65";
    EXPECT_EQ(warned(s), Texts{}) << "of what is wide the mean is the same everywhere";
    s["lights"][0]["intensity"] = {{"product", {line, band}}};
    s["materials"]["glass"].erase("transmittance");
    EXPECT_EQ(warned(s), Texts{});
    // The job's own step: one of 1 nm tells a band of 3 nm from a line.
    s["lights"][0]["intensity"] = line;
    s["materials"]["glass"]["transmittance"] = {{"center_nm", 551}, {"fwhm_nm", 3}, {"peak", 0.9}};
    json job{{"format", "bouguer-job/1"}, {"scene", s}};
    EXPECT_EQ(warned(job), Texts{"/scene/materials/glass narrow-spectra-meet"});
    job["integrator"]["wavelength_step_nm"] = 1;
    EXPECT_EQ(warned(job), Texts{});
}

TEST(CameraWarnings, NameCamerasThatLookAwayFromEverything) {
    for (const char* type : {"perspective", "orthographic"}) {
        json s = tests::good_scene();
        s["camera"] = {{"type", type}, {"from", {0, 0, 9}}, {"at", {0, 0, 0}}};
        s["camera"][type == std::string("perspective") ? "fov_deg" : "height"] = 30;
        EXPECT_EQ(warned(s), Texts{}) << type;
        s["camera"]["at"] = {0, 0, 20};
        EXPECT_EQ(warned(s), Texts{"/camera camera-sees-nothing"}) << type;
        s["camera"]["at"] = {9, 9, 20};
        EXPECT_EQ(warned(s), Texts{"/camera camera-sees-nothing"}) << type;
        s["camera"]["at"] = {0, 2, 0};
        EXPECT_EQ(warned(s), Texts{}) << type << " may see it in a wide or high picture";
    }
}

// A floor goes on for ever: from above it is seen where a ray goes down at all.
TEST(CameraWarnings, KnowThatPlanesAreEndless) {
    json s = tests::scene_with_wall();
    s["objects"][0] =
        object("floor", "wall", {{"type", "plane"}, {"point", {0, -1, 0}}, {"normal", {0, 1, 0}}});
    s["materials"].erase("glass");
    EXPECT_EQ(warned(s), Texts{});
    s["camera"]["at"] = {0, 2, 0};
    EXPECT_EQ(warned(s), Texts{}) << "upwards by 13 degrees, with 15 to each side";
    s["camera"]["at"] = {0, 4, 0};
    EXPECT_EQ(warned(s), Texts{"/camera camera-sees-nothing"});
}

TEST(CameraWarnings, NameCamerasInTheDark) {
    json s = tests::scene_with_wall();
    s["objects"][0] = object("room", "wall", kBox);
    s["materials"].erase("glass");
    s["lights"][0]["position"] = {0, 9, 0};
    EXPECT_EQ(warned(s), Texts{});
    s["camera"]["from"] = {0, 0, 2};
    EXPECT_EQ(warned(s), Texts{"/camera camera-shut-in"});
    s["lights"][0]["position"] = {0, 2, 0};
    EXPECT_EQ(warned(s), Texts{}) << "a room with a lamp";
}

}  // namespace
}  // namespace bouguer::api
