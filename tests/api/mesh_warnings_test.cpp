// SPDX-License-Identifier: Apache-2.0
// What is said of meshes: what their files had and was not read, textures that have nothing to lie
// on, surfaces that light goes through and that are no good.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "api/job_document.h"
#include "tests/support/named_bytes.h"

namespace bouguer::api {
namespace {

using nlohmann::json;
using Texts = std::vector<std::string>;

/// One file, whatever its name.
class OneFile final : public tests::NamedBytes {
  public:
    explicit OneFile(std::string content) : content_(std::move(content)) {}
    [[nodiscard]] Result<std::string> bytes(std::string_view) const override { return content_; }

  private:
    std::string content_;
};

json scene(json shape) {
    json s = json::parse(R"({"format": "bouguer-scene/1",
        "camera": {"type": "perspective", "from": [0, 0, 9], "at": [0, 0, 0], "fov_deg": 30},
        "textures": {"squares": {"type": "checker", "a": 0.1, "b": 0.9}},
        "materials": {"glass": {"type": "hall", "k_sr": 0.1, "k_st": 0.9, "ior": 1.5},
                      "wood": {"type": "hall", "k_sr": 1, "reflectance": {"texture": "squares"}},
                      "chalk": {"type": "hall", "k_sr": 1}},
        "objects": [{"name": "it", "material": "glass"}],
        "lights": [{"type": "point", "position": [0, 2, 0], "intensity": 1}]})");
    s["objects"][0]["shape"] = std::move(shape);
    return s;
}

const json kFile{{"type", "file"}, {"path", "it.obj"}};

/// "pointer code" of every warning about meshes, or of every problem.
Texts said(const json& document, const std::string& file = {}) {
    const auto job = parse_job(document.dump(), Limits{}, OneFile(file));
    Texts all;
    if (!job) {
        for (const Problem& p : job.error().problems) all.push_back(p.pointer + " " + p.code);
        return all;
    }
    for (const Warning& w : job->warnings.listed()) {
        if (w.code.find("mesh") != std::string::npos || w.code == "uvs-missing")
            all.push_back(w.pointer + " " + w.code);
    }
    return all;
}

/// A cube of glass, closed and wound outwards.
json cube() {
    return json::parse(R"({"type": "mesh",
        "positions": [[0,0,0],[1,0,0],[0,1,0],[1,1,0],[0,0,1],[1,0,1],[0,1,1],[1,1,1]],
        "triangles": [[0,2,1],[1,2,3],[4,5,6],[5,7,6],[0,1,4],[1,5,4],[2,6,3],[3,6,7],[0,4,2],
                      [2,4,6],[1,3,5],[3,7,5]]})");
}

TEST(MeshWarnings, SayNothingOfAClosedBody) { EXPECT_EQ(said(scene(cube())), Texts{}); }

TEST(MeshWarnings, NameBodiesThatAreInsideOutOpenOrDoubled) {
    json shape = cube();
    for (auto& t : shape["triangles"]) std::swap(t[1], t[2]);
    EXPECT_EQ(said(scene(shape)), Texts{"/objects/0/shape mesh-inside-out"});
    shape = cube();
    shape["triangles"].erase(0);
    EXPECT_EQ(said(scene(shape)), Texts{"/objects/0/shape mesh-open"});
    json sheet = scene(shape);
    sheet["materials"]["glass"].erase("ior");
    EXPECT_EQ(said(sheet), Texts{}) << "of a material without an inside it is a sheet";
    sheet["materials"]["glass"]["absorption"] = {{"transmittance", 0.5}};
    EXPECT_EQ(said(sheet), Texts{"/objects/0/shape mesh-open"});
    json opaque = scene(shape);
    opaque["objects"][0]["material"] = "chalk";
    EXPECT_EQ(said(opaque), Texts{}) << "what light does not enter may be open";
    shape = cube();
    shape["triangles"].push_back({7, 5, 3});
    EXPECT_EQ(said(scene(shape)), Texts{"/objects/0/shape mesh-doubled"});
}

const std::string kSquare =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

TEST(MeshWarnings, RefuseTexturesOnMeshesWithoutCoordinates) {
    json s = scene(kFile);
    s["objects"][0]["material"] = "wood";
    EXPECT_EQ(said(s, kSquare + "f 1 2 3 4\n"), Texts{"/objects/0/material mesh-without-uvs"});
    EXPECT_EQ(said(s, kSquare + "f 1/1 2/2 3/3 4/4\n"), Texts{});
    EXPECT_EQ(said(s, kSquare + "f 1/1 2/2 3/3 4/4\nf 2 5 3\n"),
              Texts{"/objects/0/material uvs-missing"});
    s["objects"][0]["material"] = "chalk";
    EXPECT_EQ(said(s, kSquare + "f 1 2 3 4\n"), Texts{});
    json inline_mesh = scene(cube());
    inline_mesh["objects"][0]["material"] = "wood";
    EXPECT_EQ(said(inline_mesh), Texts{"/objects/0/material mesh-without-uvs"});
    // What a surface gives out may be a texture, too.
    inline_mesh["materials"]["chalk"]["emission"] = {{"texture", "squares"}};
    inline_mesh["objects"][0]["material"] = "chalk";
    EXPECT_EQ(said(inline_mesh), Texts{"/objects/0/material mesh-without-uvs"});
}

// Once for a mesh, however many objects have it; with the names as the file has them.
TEST(MeshWarnings, NameWhatFilesHaveAndIsNotRead) {
    json s = scene(kFile);
    s["objects"][0]["material"] = "chalk";
    s["objects"].push_back(s["objects"][0]);
    s["objects"][1]["name"] = "again";
    const std::string file = kSquare + "l 1 2\nusemtl Gl\xc3\xa4ser\nf 1 2 3 4\nusemtl \xff\n";
    EXPECT_EQ(said(s, file), (Texts{"/objects/0/shape mesh-materials-dropped",
                                    "/objects/0/shape mesh-parts-dropped"}));
    const auto job = parse_job(s.dump(), Limits{}, OneFile(file));
    ASSERT_TRUE(job);
    const auto& all = job->warnings.listed();
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const Warning& w) {
        return w.detail.find("Gl\xc3\xa4ser") != std::string::npos;
    }));
    EXPECT_EQ(said(s, kSquare + "f 1 3 2 4\n"), Texts{"/objects/0/shape mesh-crossed-polygons"});
}

}  // namespace
}  // namespace bouguer::api
