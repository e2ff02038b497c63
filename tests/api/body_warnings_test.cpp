// SPDX-License-Identifier: Apache-2.0
// Bodies that cannot be seen, or whose insides or priorities count for nothing.
#include "api/body_warnings.h"

#include <gtest/gtest.h>

#include "tests/api/warning_testing.h"

namespace bouguer::api {
namespace {

using nlohmann::json;
using tests::object;
using tests::sphere;
using tests::Texts;
using tests::warned;

const json kDisk{{"type", "disk"}, {"center", {0, -2, 0}}, {"normal", {0, 1, 0}}, {"radius", 1}};

TEST(BodyWarnings, NameSheetsWhoseInsideCountsForNothing) {
    json s = tests::good_scene();
    s["objects"].push_back(object("film", "glass", kDisk));
    EXPECT_EQ(warned(s), Texts{"/objects/1 sheet-without-inside"});
    s["materials"]["glass"].erase("ior");
    EXPECT_EQ(warned(s), Texts{});
    s["materials"]["glass"]["absorption"] = {{"transmittance", 0.5}};
    EXPECT_EQ(warned(s), Texts{"/objects/1 sheet-without-inside"});
}

// Of two bodies at one priority the first counts: the other, inside, is not there.
TEST(BodyWarnings, NameBodiesHiddenInOthers) {
    json s = tests::good_scene();
    s["objects"].push_back(object("bubble", "glass", sphere(0, 0, 0.2, 0.4)));
    EXPECT_EQ(warned(s), Texts{"/objects/1 body-hidden"});
    s["objects"][1]["priority"] = 1;
    EXPECT_EQ(warned(s), Texts{});
    s["objects"][1].erase("priority");
    s["materials"]["air"] = {{"type", "hall"}, {"k_st", 1}, {"priority", 2}};
    s["objects"][1]["material"] = "air";
    EXPECT_EQ(warned(s), Texts{}) << "the priority of the material";
    s["objects"][1]["priority"] = 0;
    EXPECT_EQ(warned(s), Texts{"/objects/1 body-hidden"}) << "the object's replaces it";
    // The one that stands first is hidden, too, where the other counts more.
    std::swap(s["objects"][0], s["objects"][1]);
    EXPECT_EQ(warned(s), Texts{});
    s["objects"][1]["priority"] = 1;
    EXPECT_EQ(warned(s), Texts{"/objects/0 body-hidden"});
}

// The liquid of a glass: a cylinder in a cylinder whose box does not fit into the outer one.
TEST(BodyWarnings, NameWhatFillsMostOfItsHull) {
    json s = tests::good_scene();
    const auto cylinder = [](double radius, double top) {
        return json{{"type", "cylinder"},
                    {"from", {0, -0.9 * top, 0}},
                    {"to", {0, top, 0}},
                    {"radius", radius}};
    };
    s["objects"][0]["shape"] = cylinder(1, 3);
    s["objects"].push_back(object("liquid", "glass", cylinder(0.95, 2)));
    EXPECT_EQ(warned(s), Texts{"/objects/1 body-hidden"});
    s["objects"][1]["transform"] = {{{"translate", {0.1, 0, 0}}}};
    EXPECT_EQ(warned(s), Texts{}) << "it comes out of the side";
    s["objects"][0]["shape"] = sphere(0, 0, 0, 1);
    s["objects"][1] = object("core", "glass", sphere(0, 0, 0, 0.97));
    EXPECT_EQ(warned(s), Texts{"/objects/1 body-hidden"});
    s["objects"][1]["shape"]["radius"] = 1.01;
    EXPECT_EQ(warned(s), Texts{});
}

// A picture shows nothing of what is inside an opaque body, unless it is taken in there.
TEST(BodyWarnings, NameWhatIsInsideOpaqueBodies) {
    json s = tests::scene_with_wall();
    s["objects"].push_back(
        object("housing", "wall", {{"type", "box"}, {"min", {-3, -3, -3}}, {"max", {3, 1.5, 3}}}));
    EXPECT_EQ(warned(s), Texts{"/objects/0 body-hidden"});
    s["camera"]["from"] = {0, 0, 2.5};
    s["lights"][0]["position"] = {0, 1.2, 0};
    EXPECT_EQ(warned(s), Texts{}) << "a room with its camera and its lamp";
    s = tests::scene_with_wall();
    s["objects"].push_back(object("inclusion", "wall", sphere(0, 0, 0, 0.5)));
    EXPECT_EQ(warned(s), Texts{}) << "inside glass it is seen";
}

// Every instance must be hidden.
TEST(BodyWarnings, LookAtEveryInstance) {
    json s = tests::good_scene();
    s["objects"].push_back(object("bubble", "glass", sphere(0, 0, 0, 0.1)));
    s["objects"][1]["instances"] = {{{{"translate", {0.5, 0, 0}}}},
                                    {{{"translate", {-0.5, 0, 0}}}}};
    EXPECT_EQ(warned(s), Texts{"/objects/1 body-hidden"});
    s["objects"][1]["instances"][0][0]["translate"] = {2, 0, 0};
    EXPECT_EQ(warned(s), Texts{});
}

TEST(BodyWarnings, NameTwinsInOnePlace) {
    json s = tests::scene_with_wall();
    s["objects"].push_back(object("again", "wall", sphere(0, 0, 0, 1)));
    EXPECT_EQ(warned(s), Texts{"/objects/1 same-place"});
    s["objects"][1]["shape"]["radius"] = 0.9;
    EXPECT_EQ(warned(s), Texts{});
    s["objects"][1]["shape"] = sphere(0, -3, 0, 1);
    s["objects"][1]["instances"] = {
        {{{"translate", {0, 0, 0}}}}, {{{"translate", {2, 0, 0}}}}, {{{"translate", {2, 0, 0}}}}};
    EXPECT_EQ(warned(s), Texts{"/objects/1/instances/2 same-place"});
    s = tests::good_scene();
    s["objects"].push_back(object("again", "glass", sphere(0, 0, 0, 1)));
    EXPECT_EQ(warned(s), Texts{"/objects/1 same-place"}) << "once, not as hidden too";
}

TEST(BodyWarnings, NamePrioritiesWithoutEffect) {
    json s = tests::scene_with_wall();
    s["objects"].push_back(object("wall", "wall", kDisk));
    s["objects"][1]["priority"] = 3;
    EXPECT_EQ(warned(s), Texts{"/objects/1 priority-without-effect"}) << "opaque";
    s["materials"]["wall"] = {{"type", "hall"}, {"k_st", 1}};
    EXPECT_EQ(warned(s), Texts{"/objects/1 priority-without-effect"}) << "a sheet";
    s["objects"][1]["shape"] = sphere(0.5, 0, 0, 1);
    EXPECT_EQ(warned(s), Texts{});
}

// 0.9 a unit through 2 units is seen; 0.9 a thousandth of a unit is 105 in optical depth.
TEST(BodyWarnings, NameAbsorptionThatLeavesNothing) {
    json s = tests::good_scene();
    s["materials"]["glass"]["absorption"] = {{"transmittance", 0.9}, {"thickness", 1}};
    EXPECT_EQ(warned(s), Texts{});
    s["materials"]["glass"]["absorption"]["thickness"] = 0.001;
    EXPECT_EQ(warned(s), Texts{"/objects/0 absorbs-everything"});
    // A plate of 0.01 that stands aslant is thin, though the box around it is not.
    s["objects"][0]["shape"] = {{"type", "box"}, {"min", {-1, -1, 0}}, {"max", {1, 1, 0.01}}};
    s["objects"][0]["transform"] = {{{"rotate", {{"axis", {1, 1, 0}}, {"angle_deg", 45}}}}};
    EXPECT_EQ(warned(s), Texts{});
}

// Of a mesh twice the volume over the surface counts: of a cube of side a that is a / 3.
TEST(BodyWarnings, TakeTheWallOfAMeshForItsThickness) {
    json s = tests::good_scene();
    s["objects"][0]["shape"] = json::parse(R"({"type": "mesh",
        "positions": [[0,0,0],[1,0,0],[0,1,0],[1,1,0],[0,0,1],[1,0,1],[0,1,1],[1,1,1]],
        "triangles": [[0,2,1],[1,2,3],[4,5,6],[5,7,6],[0,1,4],[1,5,4],[2,6,3],[3,6,7],[0,4,2],
                      [2,4,6],[1,3,5],[3,7,5]]})");
    s["materials"]["glass"]["absorption"] = {{"transmittance", std::exp(-89)}, {"thickness", 1}};
    EXPECT_EQ(warned(s), Texts{}) << "89 / 3 is below 30";
    s["materials"]["glass"]["absorption"]["transmittance"] = std::exp(-91);
    EXPECT_EQ(warned(s), Texts{"/objects/0 absorbs-everything"});
    s["objects"][0]["transform"] = {{{"scale", 0.9}}};
    EXPECT_EQ(warned(s), Texts{});
}

TEST(BodyWarnings, NameAbsorptionThatTakesNothing) {
    json s = tests::good_scene();
    s["materials"]["glass"]["absorption"] = {{"transmittance", 0.9}, {"thickness", 1e7}};
    EXPECT_EQ(warned(s), Texts{"/objects/0 absorbs-nothing"});
    s["materials"]["glass"]["absorption"]["thickness"] = 1e3;
    EXPECT_EQ(warned(s), Texts{});
    s["materials"]["glass"]["absorption"]["transmittance"] = 1;
    EXPECT_EQ(warned(s), Texts{}) << "said to be clear";
}

}  // namespace
}  // namespace bouguer::api
