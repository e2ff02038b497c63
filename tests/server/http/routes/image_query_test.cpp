// SPDX-License-Identifier: Apache-2.0
// A finished picture asked for again, otherwise.
#include "api/digest.h"
#include "api/writers.h"
#include "renderer/film/image_decoder.h"
#include "server/jobs/result_files.h"
#include "tests/server/http/server_fixture.h"

namespace bouguer::server::testing {
namespace {

using renderer::FileColour;
using renderer::OutputSettings;

class ImageQueryTest : public ServerTest {
  protected:
    void SetUp() override {
        start();
        output.exr_colour = FileColour::Xyz;  // then the film is kept to the bit
        output.scene_white = renderer::Chromaticity{0.44758, 0.40745};
        id = add_job(output);
    }
    /// A finished job with this picture and these settings, as result_files() makes its files.
    JobId add_job(const OutputSettings& settings) {
        const JobId job = jobs.add();
        renderer::Report report;
        auto files = result_files(&film, report, settings, {});
        EXPECT_TRUE(files);
        for (auto& [name, bytes] : *files) {
            const std::string digest = api::sha256_hex(bytes);
            jobs.set_file(job, name, {bytes, std::string(media_type_of(name)), digest, true});
        }
        jobs.finish(job);
        return job;
    }
    [[nodiscard]] RawResponse png(const std::string& query,
                                  const std::vector<std::string>& fields = {}) const {
        return ask("GET", path_of(id, "/image.png?" + query), fields);
    }
    [[nodiscard]] std::string rendered(const OutputSettings& settings) const {
        return renderer::encode_png(film, settings).value();
    }

    renderer::Picture film{2, 2, {0.2F, 0.3F, 0.1F, 1, 2, 3, 0, 0, 0, 0.5F, 0.1F, 0.01F}};
    OutputSettings output;
    JobId id;
};

TEST_F(ImageQueryTest, GivesWhatARenderWithTheseSettingsGives) {
    OutputSettings wanted = output;
    wanted.display = "display-p3";
    wanted.exposure = 2;
    wanted.adaptation = renderer::Adaptation::Bradford;
    wanted.white = renderer::Chromaticity{0.4, 0.38};
    wanted.gamut = renderer::GamutMapping::Desaturate;
    const auto response =
        png("display=display-p3&exposure=2&adaptation=bradford&white=0.4,0.38&gamut=desaturate");
    ASSERT_EQ(response.status, 200) << response.body;
    EXPECT_EQ(response.header("content-type"), "image/png");
    EXPECT_EQ(response.body, rendered(wanted));
    EXPECT_NE(response.body, png("").body);
}

TEST_F(ImageQueryTest, KeepsWhatIsNotSaid) {
    EXPECT_EQ(png("").body, rendered(output));
    EXPECT_EQ(png("v=17").body, rendered(output)) << "v has no meaning";
    EXPECT_EQ(png("exposure=auto").body, rendered(output));
    EXPECT_EQ(png("gamut=clip").body, rendered(output)) << "the automatic exposure is kept";
    OutputSettings adapted = output;
    adapted.adaptation = renderer::Adaptation::Cat16;
    EXPECT_EQ(png("adaptation=cat16").body, rendered(adapted)) << "from the scene's white";
}

TEST_F(ImageQueryTest, WritesExrInOtherSpaces) {
    OutputSettings wanted = output;
    wanted.exr_colour = FileColour::AcesCg;
    const auto response = ask("GET", path_of(id, "/image.exr?color_space=acescg"));
    EXPECT_EQ(response.body, renderer::encode_exr(film, wanted).value());
    const auto chosen =
        ask("GET", path_of(id, "/image?color_space=acescg"), {"Accept: image/x-exr"});
    EXPECT_EQ(chosen.body, response.body);
    EXPECT_EQ(ask("GET", path_of(id, "/image?exposure=2"), {"Accept: image/png"}).body,
              png("exposure=2").body);
}

// Another space rounds; no value of 8 bits moves by more than one step.
TEST_F(ImageQueryTest, IsRightToOneStepFromEveryFile) {
    for (const FileColour colour :
         {FileColour::Rec709, FileColour::DisplayP3, FileColour::AcesCg}) {
        OutputSettings kept = output;
        kept.exr_colour = colour;
        id = add_job(kept);
        OutputSettings wanted = output;
        wanted.exposure = 0.4;
        const auto found = renderer::decode_image(png("exposure=0.4").body)->values();
        const auto expected = renderer::decode_image(rendered(wanted))->values();
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_NEAR(found[i], expected[i], 1.001 / 255);
    }
}

TEST_F(ImageQueryTest, RefusalsNameParameterValueAndWhatIsAllowed) {
    const auto refused = png("exposure=-1&display=tv&brightness=2");
    EXPECT_TRUE(is_problem(refused, 422, "invalid-query")) << refused.body;
    for (const char* part :
         {"query parameter exposure", R"("found":"\"-1\"")", "(0, 1e+30]",
          "query parameter display", "display-p3", "query parameter brightness", "unknown-key"}) {
        EXPECT_NE(refused.body.find(part), std::string::npos) << part << " in " << refused.body;
    }
    for (const char* query : {"exposure=1&exposure=2", "exposure=1&exposure=1", "color_space=xyz",
                              "white=", "exposure", "white=A&adaptation=none", "gamut=CLIP"}) {
        EXPECT_TRUE(is_problem(png(query), 422, "invalid-query")) << query;
    }
    EXPECT_TRUE(is_problem(ask("GET", path_of(id, "/image.exr?exposure=1")), 422, "invalid-query"));
    EXPECT_EQ(ask("GET", path_of(id, "/report?exposure=1")).status, 200);
}

TEST_F(ImageQueryTest, UnknownAndUnfinishedJobsAreToldApart) {
    const JobId unknown = "01890000-0000-7000-8000-ffffffffffff";
    EXPECT_TRUE(
        is_problem(ask("GET", path_of(unknown, "/image.png?exposure=2")), 404, "not-found"));
    EXPECT_TRUE(is_problem(ask("GET", path_of(jobs.add(), "/image.png?exposure=2")), 409,
                           "job-not-finished"));
}

TEST_F(ImageQueryTest, ConditionsRangesAndHeadWork) {
    const auto whole = png("exposure=2");
    const std::string tag = whole.header("etag");
    EXPECT_EQ(tag, '"' + api::sha256_hex(whole.body) + '"');
    EXPECT_NE(tag, png("").header("etag"));
    EXPECT_EQ(png("exposure=2", {"If-None-Match: " + tag}).status, 304);
    const auto part = png("exposure=2", {"Range: bytes=1-3"});
    EXPECT_EQ(part.status, 206);
    EXPECT_EQ(part.body, "PNG");
    const auto head = ask("HEAD", path_of(id, "/image.png?exposure=2"));
    EXPECT_EQ(head.header("content-length"), std::to_string(whole.body.size()));
}

TEST_F(ImageQueryTest, ADamagedFilmIsNotShown) {
    jobs.set_file(id, "image.exr", {Content("exr"), "image/x-exr", "bb", true});
    EXPECT_TRUE(is_problem(png("exposure=2"), 500, "result-damaged"));
}

// ---- GET /v1/compare

class CompareTest : public ImageQueryTest {
  protected:
    [[nodiscard]] std::string query_of(const JobId& a, const JobId& b) const {
        return "?a=" + a + "&b=" + b;
    }
};

TEST_F(CompareTest, AJobDoesNotDifferFromItself) {
    const auto response = ask("GET", "/v1/compare" + query_of(id, id));
    ASSERT_EQ(response.status, 200) << response.body;
    for (const char* part : {R"("mean":0.0)", R"("percentile_95":0.0)", R"("maximum":0.0)",
                             R"("compared_pixels":4)", R"("adaptation":"none")"}) {
        EXPECT_NE(response.body.find(part), std::string::npos) << part << response.body;
    }
    EXPECT_EQ(response.header("vary"), "Accept");
    EXPECT_EQ(
        ask("GET", "/v1/compare" + query_of(id, id), {"If-None-Match: " + response.header("etag")})
            .status,
        304);
}

TEST_F(CompareTest, SeesBothAsTheFirstShowsItsOwn) {
    const JobId a = id;
    for (float& v : film.xyz) v *= 0.5F;
    const JobId b = add_job(output);
    const auto own = ask("GET", "/v1/compare" + query_of(a, b)).body;
    EXPECT_EQ(own.find(R"("maximum":0.0)"), std::string::npos) << "a's exposure is that of both";
    const auto asked =
        ask("GET", "/v1/compare" + query_of(a, b) + "&exposure=0.25&white=A&display=display-p3");
    for (const char* part :
         {R"("exposure":0.25)", R"("adaptation":"cat16")", R"("display":"display-p3")"}) {
        EXPECT_NE(asked.body.find(part), std::string::npos) << part << asked.body;
    }
}

TEST_F(CompareTest, DrawsAMap) {
    const auto by_name = ask("GET", "/v1/compare.png" + query_of(id, id));
    ASSERT_EQ(by_name.status, 200);
    EXPECT_EQ(by_name.header("content-type"), "image/png");
    EXPECT_EQ(by_name.body.substr(1, 3), "PNG");
    EXPECT_EQ(ask("GET", "/v1/compare" + query_of(id, id), {"Accept: image/png"}).body,
              by_name.body);
    EXPECT_TRUE(is_problem(ask("GET", "/v1/compare" + query_of(id, id), {"Accept: text/html"}), 406,
                           "not-acceptable"));
}

TEST_F(CompareTest, RefusesWhatCannotBeCompared) {
    const JobId running = jobs.add();
    const JobId unknown = "01890000-0000-7000-8000-ffffffffffff";
    const auto missing = ask("GET", "/v1/compare?a=" + id);
    EXPECT_TRUE(is_problem(missing, 422, "invalid-query")) << missing.body;
    EXPECT_NE(missing.body.find("query parameter b"), std::string::npos);
    for (const JobId& bad : {unknown, JobId("x"), JobId("../x"), JobId()}) {
        const auto first = ask("GET", "/v1/compare" + query_of(bad, id));
        EXPECT_TRUE(is_problem(first, 404, "not-found")) << bad;
        EXPECT_NE(first.body.find("job a (" + bad), std::string::npos) << first.body;
        EXPECT_NE(ask("GET", "/v1/compare" + query_of(id, bad)).body.find("job b ("),
                  std::string::npos);
    }
    const auto early = ask("GET", "/v1/compare" + query_of(id, running));
    EXPECT_TRUE(is_problem(early, 409, "job-not-finished"));
    EXPECT_NE(early.body.find("job b ("), std::string::npos);
    film = {1, 1, {1, 1, 1}};
    const JobId small = add_job(output);
    EXPECT_TRUE(
        is_problem(ask("GET", "/v1/compare" + query_of(id, small)), 422, "different-sizes"));
    for (const char* more : {"&gamut=clip", "&exposure=0", "&c=1"}) {
        EXPECT_TRUE(
            is_problem(ask("GET", "/v1/compare" + query_of(id, id) + more), 422, "invalid-query"))
            << more;
    }
}

}  // namespace
}  // namespace bouguer::server::testing
