// SPDX-License-Identifier: Apache-2.0
#include "api/job_document.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "api/digest.h"
#include "renderer/spectrum/spectra.h"
#include "tests/api/fake_assets.h"
#include "tests/api/malformed_documents.h"
#include "tests/support/named_bytes.h"

namespace bouguer::api {
namespace {

using renderer::HallMaterial;
using renderer::PointLight;

Result<JobRequest> parse(std::string_view text) {
    return parse_job(text, Limits{}, tests::FakeAssets{});
}

std::string messages(const Result<JobRequest>& job) {
    if (job) return {};
    std::string text = job.error().message;
    for (const Problem& p : job.error().problems) text += "\n" + p.pointer + " " + p.detail;
    return text;
}

/// The example of the documentation.
constexpr std::string_view kExample = R"({ "format": "bouguer-job/1",
  "scene": {
    "format": "bouguer-scene/1", "name": "amber ball over a checkered floor", "units": "cm",
    "camera": { "type": "perspective", "from": [0, 6, 22], "at": [0, 3, 0], "up": [0, 1, 0], "fov_deg": 35,
                "resolution": [640, 480] },
    "spectra": { "amber": { "wavelengths_nm": [400, 500, 600, 700], "values": [0.2, 0.5, 0.93, 0.95] } },
    "materials": { "glass": { "type": "hall", "reflectance": 1, "transmittance": 1, "k_sr": 0.1, "k_st": 0.9, "n": 20,
                              "ior": 1.3, "absorption": { "transmittance": "amber", "thickness": 1 } },
                   "floor": { "type": "hall", "reflectance": { "srgb": [0.8, 0.75, 0.7] }, "k_sr": 0.8, "n": 1 } },
    "objects": [ { "name": "ball", "shape": { "type": "sphere", "center": [0, 3, 0], "radius": 3 }, "material": "glass" },
                 { "name": "floor", "shape": { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0] }, "material": "floor" } ],
    "lights": [ { "type": "point", "position": [10, 20, 15], "intensity": { "spectrum": "D65", "scale": 400 } } ],
    "ambient": { "k_a": 0.3, "weights": "hemisphere" } },
  "integrator": { "type": "hall", "max_depth": 8 },
  "stop": { "samples": 16 },
  "output": { "display": "srgb" }, "seed": 1 })";

TEST(JobDocument, ReadsTheExample) {
    const auto job = parse(kExample);
    ASSERT_TRUE(job) << messages(job);
    const auto& scene = job->scene;
    EXPECT_EQ(scene.metres_per_unit, 0.01);
    EXPECT_EQ(scene.resolution, (renderer::Resolution{640, 480}));
    const auto& camera = std::get<renderer::PerspectiveCamera>(scene.camera);
    EXPECT_EQ(camera.from, (renderer::Vec3{0, 6, 22}));
    EXPECT_EQ(camera.fov_deg, 35);
    ASSERT_EQ(scene.objects.size(), 2U);
    EXPECT_EQ(std::get<renderer::Sphere>(scene.objects[0].placed.shape).radius, 3);
    EXPECT_EQ(scene.materials[scene.objects[0].material].name, "glass");
    const auto& glass = std::get<HallMaterial>(scene.materials[scene.objects[0].material].model);
    EXPECT_EQ(glass.n, 20);
    EXPECT_TRUE(glass.mirror);
    ASSERT_TRUE(glass.absorption);
    EXPECT_NEAR(glass.absorption->transmittance->at(450), 0.35, 1e-12);
    const auto& floor = std::get<HallMaterial>(scene.materials[scene.objects[1].material].model);
    EXPECT_FALSE(floor.mirror);
    EXPECT_EQ(floor.k_st, 0);
    // D65 is 1 at 560 nm.
    EXPECT_NEAR(std::get<PointLight>(scene.lights.at(0)).intensity->at(560), 400, 1e-9);
    ASSERT_TRUE(scene.ambient);
    EXPECT_EQ(std::get<renderer::HemisphereWeights>(scene.ambient->weights).rays, 1);
    EXPECT_EQ(job->stop.samples, 16U);
    EXPECT_FALSE(job->stop.seconds);
    EXPECT_EQ(job->settings.resolution, scene.resolution);
    EXPECT_EQ(job->settings.seed, 1U);
    EXPECT_FALSE(job->output.exposure);
}

TEST(JobDocument, ReadsOneOfEverything) {
    const auto job = parse(tests::wellformed_document());
    ASSERT_TRUE(job) << messages(job);
    const auto& scene = job->scene;
    ASSERT_EQ(scene.objects.size(), 6U);
    EXPECT_EQ(scene.lights.size(), 2U);
    EXPECT_TRUE(scene.environment);
    EXPECT_EQ(job->settings.crop, (renderer::Crop{8, 8, 16, 16}));
    EXPECT_EQ(job->stop.error, 0.01);
    EXPECT_EQ(job->labels.at("project"), "test");
    const auto& mesh =
        std::get<std::shared_ptr<const renderer::TriangleMesh>>(scene.objects[5].placed.shape);
    EXPECT_EQ(mesh->triangles.size(), 2U);
    EXPECT_EQ(mesh->uvs.size(), 4U);
    EXPECT_EQ(scene.objects[5].placed.instances.at(0).point({1, 1, 1}), (renderer::Vec3{3, 3, 3}));
    EXPECT_EQ(scene.objects[4].placed.instances.size(), 2U);
    // The lamp is named by way of another name.
    EXPECT_NEAR(std::get<PointLight>(scene.lights[0]).intensity->at(560), 400, 1e-9);
}

// Steps apply in the order written: turned, then scaled, then moved. [x, 0, 0] turned by 90 degrees
// about z is [0, x, 0]; the instance comes after the object's own transform.
TEST(JobDocument, AppliesTransformsInTheOrderWritten) {
    const auto job = parse(R"({"format":"bouguer-scene/1",
        "camera":{"type":"orthographic","from":[0,0,9],"at":[0,0,0],"height":2},
        "materials":{"m":{"type":"hall","k_sr":1}},
        "objects":[{"name":"o","material":"m","shape":{"type":"sphere","center":[0,0,0],"radius":1},
          "transform":[{"rotate":{"axis":[0,0,1],"angle_deg":90}},{"scale":[1,2,1]},{"translate":[1,0,0]}],
          "instances":[{"matrix":[[10,0,0,0],[0,10,0,0],[0,0,10,5],[0,0,0,1]]}]}]})");
    ASSERT_TRUE(job) << messages(job);
    const renderer::Vec3 p = job->scene.objects[0].placed.instances.at(0).point({3, 0, 0});
    EXPECT_NEAR(p.x, 10, 1e-12);
    EXPECT_NEAR(p.y, 60, 1e-12);
    EXPECT_NEAR(p.z, 5, 1e-12);
}

TEST(JobDocument, WeighsObjectsThatAreNotNamedByZero) {
    const auto job = parse(R"({"format":"bouguer-scene/1",
        "camera":{"type":"orthographic","from":[0,0,9],"at":[0,0,0],"height":2},
        "materials":{"m":{"type":"hall","k_sr":1}},
        "objects":[{"name":"a","material":"m","shape":{"type":"sphere","center":[0,0,0],"radius":1}},
                   {"name":"b","material":"m","shape":{"type":"sphere","center":[3,0,0],"radius":1}}],
        "ambient":{"k_a":0.5,"weights":{"b":0.25}}})");
    ASSERT_TRUE(job) << messages(job);
    EXPECT_EQ(std::get<renderer::ExplicitWeights>(job->scene.ambient->weights).k,
              (std::vector<renderer::Real>{0, 0.25}));
    EXPECT_EQ(job->scene.ambient->illuminant, nullptr);
}

// A lamp behind a filter: wavelength by wavelength, by whatever names.
TEST(JobDocument, MultipliesSpectra) {
    const auto job = parse(R"({"format":"bouguer-scene/1",
        "camera":{"type":"orthographic","from":[0,0,9],"at":[0,0,0],"height":2},"objects":[],
        "spectra":{"bell":{"center_nm":560,"fwhm_nm":40,"peak":0.5},
                   "filtered":{"product":["D65","bell",{"spectrum":"bell","scale":2}]}},
        "lights":[{"type":"point","position":[0,0,1],"intensity":"filtered"}]})");
    ASSERT_TRUE(job) << messages(job);
    const auto& intensity = *std::get<PointLight>(job->scene.lights[0]).intensity;
    EXPECT_NEAR(intensity.at(560), 0.5, 1e-9);  // D65 is 1 there: 1 x 0.5 x 1
    // Half the width away each bell is at half its peak.
    EXPECT_NEAR(intensity.at(580) / renderer::library_spectrum("D65")->at(580), 0.125, 1e-9);
}

TEST(JobDocument, ReadsMeshFilesThroughItsAssets) {
    const auto with = [](std::string_view path) {
        return parse(R"({"format":"bouguer-scene/1",
            "camera":{"type":"perspective","from":[0,0,9],"at":[0,0,0]},
            "materials":{"m":{"type":"hall","k_sr":1}},
            "objects":[{"name":"o","material":"m","shape":{"type":"file","path":")" +
                     std::string(path) + R"("}}]})");
    };
    EXPECT_TRUE(with("triangle.ply")) << messages(with("triangle.ply"));
    const auto noise = with("noise.ply");
    ASSERT_FALSE(noise);
    EXPECT_EQ(noise.error().problems.at(0).pointer, "/objects/0/shape/path");
    EXPECT_EQ(noise.error().problems.at(0).code, "bad-mesh");
    EXPECT_EQ(noise.error().problems.at(0).detail, "line 3: not a number: \"zero\"");
    // A broken disk is not the document's fault.
    ASSERT_FALSE(with("broken.ply"));
    EXPECT_EQ(with("broken.ply").error().kind, ErrorKind::Internal);
}

TEST(JobDocument, TakesABareSceneAsAJobWithEveryDefault) {
    const std::string scene = R"({"format":"bouguer-scene/1","objects":[],)"
                              R"("camera":{"type":"perspective","from":[0,0,1],"at":[0,0,0]}})";
    const auto bare = parse(scene);
    const auto job = parse(R"({"format":"bouguer-job/1","scene":)" + scene + "}");
    ASSERT_TRUE(bare) << messages(bare);
    ASSERT_TRUE(job) << messages(job);
    EXPECT_EQ(bare->canonical, job->canonical);
    EXPECT_EQ(bare->digest, job->digest);
    EXPECT_EQ(bare->stop.samples, 16U);
    EXPECT_EQ(bare->settings.resolution, (renderer::Resolution{640, 480}));
    ASSERT_FALSE(parse_scene(kExample, Limits{}, tests::FakeAssets{}));
    EXPECT_TRUE(parse_scene(scene, Limits{}, tests::FakeAssets{}));
}

TEST(JobDocument, IsNamedByItsCanonicalForm) {
    const std::string camera = R"("camera":{"at":[0,0,0],"from":[0,0,1],"type":"perspective"})";
    const std::string scene = "{" + camera + R"(,"format":"bouguer-scene/1","objects":[]})";
    const auto a = parse(R"({ "priority": 3, "labels": {"x": "y"}, "format": "bouguer-job/1",
                              "scene": { "objects": [], "format": "bouguer-scene/1", )" +
                         camera + "} }");
    ASSERT_TRUE(a) << messages(a);
    EXPECT_EQ(
        a->canonical,
        R"({"format":"bouguer-job/1","labels":{"x":"y"},"priority":3,"scene":)" + scene + "}");
    EXPECT_EQ(a->scene_digest, "sha256-" + sha256_hex(scene));
    // Neither priority nor labels change what is rendered.
    EXPECT_EQ(a->digest,
              "sha256-" + sha256_hex(R"({"format":"bouguer-job/1","scene":)" + scene + "}"));
    const auto again = parse(a->canonical);
    ASSERT_TRUE(again) << messages(again);
    EXPECT_EQ(again->canonical, a->canonical);
    EXPECT_EQ(again->digest, a->digest);
}

TEST(JobDocument, AcceptsIntegersWrittenWithAPoint) {
    const auto job = parse(R"({"format":"bouguer-job/1","seed":16.0,"stop":{"samples":4e0},
        "scene":{"format":"bouguer-scene/1","objects":[],
                 "camera":{"type":"perspective","from":[0,0,1],"at":[0,0,0]}}})");
    ASSERT_TRUE(job) << messages(job);
    EXPECT_EQ(job->settings.seed, 16U);
    EXPECT_EQ(job->stop.samples, 4U);
}

// Without `samples` a render ends at the limits of the service at the latest.
TEST(JobDocument, BoundsARenderThatStopsByError) {
    const auto job = parse(R"({"format":"bouguer-job/1","stop":{"error":0.001},
        "scene":{"format":"bouguer-scene/1","objects":[],
                 "camera":{"type":"perspective","from":[0,0,1],"at":[0,0,0],"resolution":[2000,1000]}}})");
    ASSERT_TRUE(job) << messages(job);
    EXPECT_EQ(job->stop.samples, 50'000U);  // 1e11 / 2e6
}

TEST(JobDocument, RefusesABodyOverTheLimitBeforeReadingIt) {
    Limits limits;
    const std::string text(limits.body_bytes + 1, '[');
    const auto job = parse_job(text, limits, tests::FakeAssets{});
    ASSERT_FALSE(job);
    EXPECT_EQ(job.error().kind, ErrorKind::TooLarge);
}

class CountingAssets final : public tests::NamedBytes {
  public:
    [[nodiscard]] Result<std::string> bytes(std::string_view name) const override {
        ++calls;
        return tests::FakeAssets{}.bytes(name);
    }
    mutable int calls = 0;
};

// However often a document names a file: one mesh, read once.
TEST(JobDocument, ReadsAFileOnce) {
    std::string objects;
    for (int i = 0; i < 50; ++i) {
        objects += std::string(i == 0 ? "" : ",") + R"({"name":"o)" + std::to_string(i) +
                   R"(","shape":{"type":"file","path":"triangle.ply"},"material":"m"})";
    }
    const CountingAssets assets;
    const auto job = parse_job(
        R"({"format":"bouguer-scene/1","camera":{"type":"perspective","from":[0,0,1],"at":[0,0,0]},
            "materials":{"m":{"type":"hall","k_sr":1}},"objects":[)" +
            objects + "]}",
        Limits{}, assets);
    ASSERT_TRUE(job) << messages(job);
    EXPECT_EQ(assets.calls, 2);  // its first bytes, then all of them
    using Mesh = std::shared_ptr<const renderer::TriangleMesh>;
    EXPECT_EQ(std::get<Mesh>(job->scene.objects[0].placed.shape),
              std::get<Mesh>(job->scene.objects[49].placed.shape));
}

/// One file, whatever its name.
class OneFile final : public tests::NamedBytes {
  public:
    explicit OneFile(std::string bytes) : bytes_(std::move(bytes)) {}
    [[nodiscard]] Result<std::string> bytes(std::string_view /*name*/) const override {
        return bytes_;
    }

  private:
    std::string bytes_;
};

// The document stays and what its path leads to changes; what is named by its digest cannot.
TEST(JobDocument, KnowsTheContentOfFilesNamedByAPath) {
    const std::string a = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", b = "v 9 9 0\n" + a;
    const auto files_digest = [](const std::string& bytes, const std::string& named) {
        const auto job = parse_job(R"({"format":"bouguer-scene/1",
            "camera":{"type":"perspective","from":[0,0,9],"at":[0,0,0]},
            "materials":{"m":{"type":"hall","k_sr":1}},
            "objects":[{"name":"o","material":"m","shape":{"type":"file",)" +
                                       named + "}}]}",
                                   Limits{}, OneFile(bytes));
        EXPECT_TRUE(job) << messages(job);
        return job ? job->files_digest : "refused";
    };
    const std::string by_path = R"("path":"a.obj")";
    EXPECT_EQ(files_digest(a, by_path), files_digest(a, by_path));
    EXPECT_NE(files_digest(a, by_path), files_digest(b, by_path));
    EXPECT_EQ(files_digest(a, R"("asset":")" + digest_of(a) + "\""), "");
}

// As large as a body may be and wrong all over: the report stays short and counts the rest.
TEST(JobDocument, ListsTheFirstProblemsOfAHugeDocumentAndCountsTheRest) {
    const Limits limits;
    std::string text = R"({"format":"bouguer-job/1","scene":{"format":"bouguer-scene/1",)"
                       R"("camera":{"type":"perspective","from":[0,0,1],"at":[0,0,0]},"objects":[)";
    std::size_t objects = 0;
    for (; objects < limits.objects; ++objects) {
        text += R"({"name":1,"shape":2,"material":3},)";
    }
    text.back() = ']';
    text += "}}";
    text.resize(limits.body_bytes, ' ');
    const auto job = parse_job(text, limits, tests::FakeAssets{});
    ASSERT_FALSE(job);
    EXPECT_EQ(job.error().problems.size(), limits.problems);
    EXPECT_NE(job.error().message.find(std::to_string(3 * objects)), std::string::npos)
        << job.error().message;
}

struct LimitCase {
    std::string name;
    void (*lower)(Limits&);
    std::string pointer;
};

class JobDocumentLimit : public testing::TestWithParam<LimitCase> {};

// Every limit is enforced: lowered under what the document with one of everything has, it is hit.
TEST_P(JobDocumentLimit, IsReportedWithWhatIsAllowed) {
    Limits limits;
    GetParam().lower(limits);
    const auto job = parse_job(tests::wellformed_document(), limits, tests::FakeAssets{});
    ASSERT_FALSE(job);
    ASSERT_EQ(job.error().problems.size(), 1U) << messages(job);
    const Problem& problem = job.error().problems[0];
    EXPECT_EQ(problem.pointer, GetParam().pointer);
    EXPECT_EQ(problem.code, "over-limit");
    EXPECT_FALSE(problem.found.empty());
    EXPECT_FALSE(problem.allowed.empty());
}

INSTANTIATE_TEST_SUITE_P(
    All, JobDocumentLimit,
    testing::Values(
        LimitCase{"objects", [](Limits& l) { l.objects = 5; }, "/scene/objects"},
        LimitCase{"instances", [](Limits& l) { l.instances = 5; }, "/scene/objects/4/instances"},
        LimitCase{"materials", [](Limits& l) { l.materials = 2; }, "/scene/materials"},
        LimitCase{"lights", [](Limits& l) { l.lights = 1; }, "/scene/lights"},
        LimitCase{"spectra", [](Limits& l) { l.spectra = 4; }, "/scene/spectra"},
        LimitCase{"textures", [](Limits& l) { l.textures = 2; }, "/scene/textures"},
        LimitCase{"texture_pixels", [](Limits& l) { l.texture_pixels = 1; },
                  "/scene/textures/photo/path"},
        LimitCase{"scene_texture_pixels", [](Limits& l) { l.scene_texture_pixels = 1; },
                  "/scene/textures/photo/path"},
        LimitCase{"mesh_vertices", [](Limits& l) { l.mesh_vertices = 3; },
                  "/scene/objects/5/shape/positions"},
        LimitCase{"mesh_triangles", [](Limits& l) { l.mesh_triangles = 1; },
                  "/scene/objects/5/shape/triangles"},
        LimitCase{"transform_steps", [](Limits& l) { l.transform_steps = 2; },
                  "/scene/objects/3/transform"},
        LimitCase{"samples", [](Limits& l) { l.samples = 15; }, "/stop/samples"},
        LimitCase{"seconds", [](Limits& l) { l.seconds = 59; }, "/stop/seconds"},
        LimitCase{"max_depth", [](Limits& l) { l.max_depth = 7; }, "/integrator/max_depth"},
        LimitCase{"labels", [](Limits& l) { l.labels = 0; }, "/labels"},
        LimitCase{"pixel_samples", [](Limits& l) { l.pixel_samples = 16 * 16 * 16 - 1; },
                  "/stop/samples"}),
    [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace bouguer::api
