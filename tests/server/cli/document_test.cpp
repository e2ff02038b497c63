// SPDX-License-Identifier: Apache-2.0
#include "server/cli/document.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "server/cli/command_line.h"
#include "tests/server/jobs/small_job.h"
#include "tests/server/storage/temporary_folder.h"

namespace bouguer::server {
namespace {

class DocumentTest : public testing::Test {
  protected:
    std::filesystem::path write(const std::string& name, const std::string& text) {
        std::ofstream(folder_.path() / name) << text;
        return folder_.path() / name;
    }
    TemporaryFolder folder_;
};

TEST_F(DocumentTest, ReadsAJobWithMeshesBesideIt) {
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    std::string text = small_job();
    const std::string sphere = R"({"type":"sphere","center":[0,1,0],"radius":1})";
    text.replace(text.find(sphere), sphere.size(), R"({"type":"file","path":"a.obj"})");
    const auto job = read_document(write("job.json", text));
    ASSERT_TRUE(job) << job.error().problems.at(0).detail;
    EXPECT_EQ(job->scene.objects.size(), 2U);
}

TEST_F(DocumentTest, SaysWhatIsMissing) {
    EXPECT_EQ(read_document(folder_.path() / "none.json").error().kind, ErrorKind::NotFound);
    EXPECT_EQ(read_document(write("bad.json", "{")).error().kind, ErrorKind::Malformed);
}

TEST_F(DocumentTest, OverridesWhatTheDocumentSays) {
    auto job = read_document(write("job.json", small_job(4)));
    ASSERT_TRUE(job);
    EXPECT_NE(job->digest, "");
    Overrides overrides;
    overrides.integrator = "rgb";
    overrides.seconds = 2.5;
    overrides.seed = 77;
    overrides.output["display"] = "lee-9300k";
    overrides.output["exposure"] = "0.5";
    overrides.output["color_space"] = "xyz";
    overrides.output["white"] = "A";
    overrides.resolution = "10x20";
    overrides.wavelength_step = 20;
    overrides.max_depth = 2;
    ASSERT_TRUE(apply_overrides(*job, overrides));
    EXPECT_EQ(job->settings.integrator, renderer::IntegratorType::Rgb);
    EXPECT_EQ(job->stop.seconds, 2.5);
    EXPECT_FALSE(job->stop.samples) << "the document's stop rule is replaced as a whole";
    EXPECT_EQ(job->settings.seed, 77U);
    EXPECT_EQ(job->output.display, "lee-9300k");
    EXPECT_EQ(job->output.exposure, 0.5);
    EXPECT_EQ(job->output.exr_colour, renderer::FileColour::Xyz);
    EXPECT_EQ(job->output.adaptation, renderer::Adaptation::Cat16);
    EXPECT_EQ(job->settings.resolution, (renderer::Resolution{10, 20}));
    EXPECT_EQ(job->settings.wavelength_step_nm, 20);
    EXPECT_EQ(job->settings.max_depth, 2);
    EXPECT_EQ(job->digest, "") << "it is no longer the document that is rendered";
}

TEST_F(DocumentTest, WithoutOverridesNothingChanges) {
    auto job = read_document(write("job.json", small_job(4)));
    ASSERT_TRUE(job);
    const std::string digest = job->digest;
    ASSERT_TRUE(apply_overrides(*job, {}));
    EXPECT_EQ(job->digest, digest);
    EXPECT_EQ(job->stop.samples, 4U);
}

TEST_F(DocumentTest, RefusesEveryOverrideThatDoesNotFit) {
    auto job = read_document(write("job.json", small_job(4, R"(,"output":{"crop":[4,4,12,8]})")));
    ASSERT_TRUE(job);
    for (const char* resolution :
         {"10", "x", "10x", "0x10", "10x-1", "10x10x10", "99999x10", "8x8"}) {
        Overrides overrides;
        overrides.resolution = resolution;
        const auto applied = apply_overrides(*job, overrides);
        ASSERT_FALSE(applied) << resolution;
        EXPECT_EQ(applied.error().problems.at(0).pointer, "--resolution");
    }
    Overrides two;
    two.output["display"] = "tv";
    two.output["exposure"] = "bright";
    two.output["color_space"] = "srgb";
    const auto refused = apply_overrides(*job, two);
    ASSERT_EQ(refused.error().problems.size(), 3U);
    EXPECT_EQ(refused.error().problems[2].pointer, "--color-space");
}

TEST(PrintError, NamesEveryProblem) {
    std::ostringstream out;
    const Error error{ErrorKind::InvalidInput,
                      "the document is refused",
                      {{"/a", "out-of-range", "too large", "2", "a number in [0, 1]"},
                       {"", "missing", "no scene", "", ""},
                       {"/b", "missing", "is missing", "", "a number"}},
                      {}};
    EXPECT_EQ(print_error(out, error), kExitBadInput);
    EXPECT_EQ(out.str(),
              "bouguer: the document is refused\n"
              "/a: too large (found 2, allowed a number in [0, 1])\n"
              "(document): no scene\n"
              "/b: is missing (found nothing, allowed a number)\n");
    EXPECT_EQ(print_error(out, {ErrorKind::Internal, "disk full", {}, {}}), kExitFailed);
}

TEST(PrintWarnings, ListsSomeOfEachCodeAndCountsTheOthers) {
    Warnings warnings;
    for (int i = 0; i < 1000; ++i)
        warnings.add({"/materials/m", "unused-material", "unused", "remove it"});
    warnings.add({"", "body-lost", "lost", "close it"});
    std::ostringstream out;
    print_warnings(out, warnings);
    const std::string text = out.str();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), Warnings::kMostOfOneCode + 2);
    EXPECT_NE(text.find("warning: /materials/m: unused; remove it [unused-material]\n"),
              std::string::npos);
    EXPECT_NE(text.find("warning: lost; close it [body-lost]\n"), std::string::npos);
    EXPECT_NE(text.find("980 of unused-material"), std::string::npos);
}

}  // namespace
}  // namespace bouguer::server
