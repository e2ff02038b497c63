// SPDX-License-Identifier: Apache-2.0
#include "tests/server/http/server_fixture.h"

namespace bouguer::server::testing {
namespace {

class ResultRoutesTest : public ServerTest {
  protected:
    void SetUp() override {
        start();
        id = jobs.add();
        jobs.set_file(id, "image.png", {Content("0123456789"), "image/png", "aa11", false});
        jobs.set_file(id, "image.exr", {Content("exr"), "image/x-exr", "bb22", true});
        jobs.set_file(id, "error.json", {Content("{}"), "application/json", "cc33", true});
        jobs.set_file(id, "error.csv", {Content("a,b"), "text/csv", "dd44", true});
        jobs.set_file(id, "error.png", {Content("plot"), "image/png", "ee55", true});
    }
    [[nodiscard]] RawResponse image(const std::vector<std::string>& fields) const {
        return ask("GET", path_of(id, "/image.png"), fields);
    }

    JobId id;
};

TEST_F(ResultRoutesTest, ImagesAreChosenByNameOrByAccept) {
    EXPECT_EQ(image({}).body, "0123456789");
    EXPECT_EQ(ask("GET", path_of(id, "/image.exr")).header("content-type"), "image/x-exr");
    const auto exr = ask("GET", path_of(id, "/image"), {"Accept: image/x-exr, */*;q=0.1"});
    EXPECT_EQ(exr.body, "exr");
    EXPECT_EQ(exr.header("vary"), "Accept");
    EXPECT_EQ(ask("GET", path_of(id, "/image")).header("content-type"), "image/png");
    EXPECT_TRUE(is_problem(ask("GET", path_of(id, "/image"), {"Accept: text/html"}), 406,
                           "not-acceptable"));
    EXPECT_EQ(ask("GET", path_of(id, "/error"), {"Accept: text/csv"}).body, "a,b");
    EXPECT_EQ(ask("GET", path_of(id, "/error")).body, "{}");
    EXPECT_EQ(ask("GET", path_of(id, "/error.csv")).body, "a,b");
    EXPECT_EQ(ask("GET", path_of(id, "/error.png")).body, "plot");
    EXPECT_EQ(ask("GET", path_of(id, "/error"), {"Accept: image/*"}).body, "plot");
}

TEST_F(ResultRoutesTest, BeforeThereIsAnythingIsAConflict) {
    EXPECT_TRUE(is_problem(ask("GET", path_of(id, "/report")), 409, "job-not-finished"));
    EXPECT_TRUE(is_problem(ask("GET", path_of(id, "/image.jpg")), 404, "not-found"));
    EXPECT_TRUE(is_problem(ask("GET", path_of(id, "/imageXpng")), 404, "not-found"));
}

TEST_F(ResultRoutesTest, OnlyFinalResultsMayBeKept) {
    EXPECT_EQ(image({}).header("cache-control"), "no-cache");
    EXPECT_NE(ask("GET", path_of(id, "/image.exr")).header("cache-control").find("immutable"),
              std::string::npos);
}

TEST_F(ResultRoutesTest, KnownTagsAnswer304) {
    EXPECT_EQ(image({}).header("etag"), "\"aa11\"");
    for (const char* field : {"\"aa11\"", "W/\"aa11\"", "\"x\", \"aa11\"", "*"}) {
        const auto response = image({std::string("If-None-Match: ") + field});
        EXPECT_EQ(response.status, 304) << field;
        EXPECT_EQ(response.header("etag"), "\"aa11\"");
        EXPECT_TRUE(response.body.empty());
    }
    EXPECT_EQ(image({"If-None-Match: \"zz\""}).status, 200);
}

// RFC 9110 §13.1.1: by strong comparison, so that a weak tag never matches.
TEST_F(ResultRoutesTest, OtherTagsThanExpectedAnswer412) {
    for (const char* field : {"\"aa11\"", "\"x\", \"aa11\"", "W/\"aa11\", \"aa11\"", "*",
                              "\"x\" ,\"aa11\"", "\"a,\",\"aa11\""}) {
        EXPECT_EQ(image({std::string("If-Match: ") + field}).status, 200) << field;
    }
    for (const char* field : {"\"x\"", "W/\"aa11\"", "aa11", "", "**", "\"x,\"aa11\"\""}) {
        EXPECT_TRUE(
            is_problem(image({std::string("If-Match: ") + field}), 412, "precondition-failed"))
            << field;
    }
    EXPECT_EQ(image({"If-Match: \"x\"", "If-None-Match: \"aa11\""}).status, 412);
    EXPECT_EQ(image({"If-Match: \"x\""}).header("etag"), "\"aa11\"") << "what is here now";
    EXPECT_EQ(image({"If-Match: \"x\"", "If-Match: \"aa11\""}).status, 200) << "in two lines";
    EXPECT_EQ(image({"If-None-Match: \"x\"", "If-None-Match: \"aa11\""}).status, 304) << "likewise";
    EXPECT_EQ(image({"If-Match: \"aa11\"", "Range: bytes=2-4"}).body, "234");
    EXPECT_EQ(ask("HEAD", path_of(id, "/image.png"), {"If-Match: \"x\""}).status, 412);
    EXPECT_EQ(ask("GET", path_of(id, "/report"), {"If-Match: \"x\""}).status, 409);
}

TEST_F(ResultRoutesTest, RangesGivePartsWithTheEndClamped) {
    EXPECT_EQ(image({}).header("accept-ranges"), "bytes");
    const auto middle = image({"Range: bytes=2-4"});
    EXPECT_EQ(middle.status, 206);
    EXPECT_EQ(middle.body, "234");
    EXPECT_EQ(middle.header("content-range"), "bytes 2-4/10");
    const auto end = image({"Range: bytes=8-4000"});
    EXPECT_EQ(end.status, 206);
    EXPECT_EQ(end.body, "89");
    EXPECT_EQ(end.header("content-range"), "bytes 8-9/10");
    EXPECT_EQ(image({"Range: bytes=-3"}).body, "789");
    const auto behind = image({"Range: bytes=10-"});
    EXPECT_TRUE(is_problem(behind, 416, "range-not-satisfiable")) << behind.body;
    EXPECT_EQ(behind.header("content-range"), "bytes */10");
    EXPECT_EQ(image({"Range: bytes=0-1,3-4"}).body, "0123456789");
    EXPECT_EQ(image({"Range: nonsense"}).status, 200);
}

TEST_F(ResultRoutesTest, IfRangeGuardsAgainstMixingTwoVersions) {
    EXPECT_EQ(image({"Range: bytes=2-4", "If-Range: \"aa11\""}).status, 206);
    EXPECT_EQ(image({"Range: bytes=2-4", "If-Range: \"other\""}).body, "0123456789");
    EXPECT_EQ(image({"Range: bytes=2-4", "If-Range: Sat, 01 Jan 2022 00:00:00 GMT"}).status, 200);
}

TEST_F(ResultRoutesTest, HeadSaysTheSizeAndIgnoresRanges) {
    const auto head = ask("HEAD", path_of(id, "/image.png"), {"Range: bytes=2-4"});
    EXPECT_EQ(head.status, 200);
    EXPECT_EQ(head.header("content-length"), "10");
}

TEST_F(ResultRoutesTest, RangesOfOtherAnswersAreIgnored) {
    EXPECT_EQ(ask("GET", path_of(id), {"Range: bytes=2-4"}).status, 200);
}

}  // namespace
}  // namespace bouguer::server::testing
