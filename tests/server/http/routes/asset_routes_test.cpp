// SPDX-License-Identifier: Apache-2.0
#include "api/digest.h"
#include "tests/server/http/server_fixture.h"

namespace bouguer::server::testing {
namespace {

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

class AssetRoutesTest : public ServerTest {
  protected:
    [[nodiscard]] RawResponse put(const std::string& digest, const std::string& body) const {
        return ask("PUT", "/v1/assets/" + digest, {"Content-Type: application/octet-stream"}, body);
    }
    const std::string digest_ = api::digest_of(kObj);
};

TEST_F(AssetRoutesTest, AFileIsPutOnceAndFetched) {
    start();
    const auto first = put(digest_, kObj);
    EXPECT_EQ(first.status, 201) << first.body;
    EXPECT_EQ(first.header("location"), "/v1/assets/" + digest_);
    EXPECT_NE(first.body.find("\"media_type\":\"model/obj\""), std::string::npos) << first.body;
    EXPECT_EQ(put(digest_, kObj).status, 200);
    const auto file = ask("GET", "/v1/assets/" + digest_);
    EXPECT_EQ(file.status, 200);
    EXPECT_EQ(file.body, kObj);
    EXPECT_EQ(file.header("content-type"), "model/obj");
    EXPECT_EQ(file.header("etag"), "\"" + digest_ + "\"");
    EXPECT_NE(file.header("cache-control").find("immutable"), std::string::npos);
    EXPECT_EQ(ask("HEAD", "/v1/assets/" + digest_).status, 200);
}

TEST_F(AssetRoutesTest, AFileIsPutUnderTheConditionsOfItsTag) {
    start();
    const std::string path = "/v1/assets/" + digest_;
    const std::string tag = '"' + digest_ + '"';
    EXPECT_TRUE(is_problem(ask("PUT", path, {"If-Match: *"}, kObj), 412, "precondition-failed"));
    EXPECT_EQ(ask("PUT", path, {"If-None-Match: *"}, kObj).status, 201);
    EXPECT_TRUE(
        is_problem(ask("PUT", path, {"If-None-Match: *"}, kObj), 412, "precondition-failed"));
    EXPECT_EQ(ask("PUT", path, {"If-Match: " + tag}, kObj).status, 200);
    EXPECT_TRUE(is_problem(ask("GET", path, {"If-Match: \"other\""}), 412, "precondition-failed"));
    EXPECT_EQ(ask("GET", path, {"If-Match: " + tag}).body, kObj);
}

// As clients send it that do not think of the type: of a form the library would refuse 8 KiB.
TEST_F(AssetRoutesTest, TheMediaTypeDoesNotCount) {
    start();
    const std::string large = kObj + std::string(20'000, '\n');
    for (const char* type : {"application/x-www-form-urlencoded", "multipart/form-data", "x"}) {
        const auto answer =
            ask_raw("PUT /v1/assets/" + api::digest_of(large) +
                    " HTTP/1.1\r\nHost: h\r\nContent-Type: " + type +
                    "\r\nContent-Length: " + std::to_string(large.size()) + "\r\n\r\n" + large);
        EXPECT_EQ(answer.status / 100, 2) << type << answer.body;
    }
}

TEST_F(AssetRoutesTest, WhatIsWrongWithAFileIsSaid) {
    start();
    const std::string other = api::digest_of("other");
    const auto mismatch = put(other, kObj);
    EXPECT_TRUE(is_problem(mismatch, 422, "digest-mismatch")) << mismatch.body;
    EXPECT_NE(mismatch.body.find(digest_), std::string::npos);
    EXPECT_TRUE(is_problem(put(api::digest_of("GIF89a"), "GIF89a"), 422, "unknown-type"));
    EXPECT_TRUE(is_problem(ask("GET", "/v1/assets/" + other), 404, "not-found"));
    EXPECT_TRUE(is_problem(put("sha256-12", kObj), 404, "not-found"));
    EXPECT_TRUE(is_problem(ask("DELETE", "/v1/assets/" + digest_), 405, "method-not-allowed"));
}

// Larger than a document may be, as large as an asset may be, and one byte more.
TEST_F(AssetRoutesTest, AFileMayBeLargerThanADocument) {
    HttpOptions options;
    options.limits.body_bytes = 100;
    options.limits.asset_bytes = 200;
    start(options);
    const std::string large = kObj + std::string(200 - kObj.size(), '\n');
    EXPECT_EQ(put(api::digest_of(large), large).status, 201);
    EXPECT_TRUE(is_problem(put(digest_, large + "\n"), 413, "content-too-large"));
    EXPECT_EQ(ask("POST", "/v1/jobs", {}, large).status, 413);
    EXPECT_EQ(ask("PUT", "/v1/jobs", {}, large).status, 413);
    const std::string chunked =
        "PUT /v1/assets/" + digest_ + " HTTP/1.1\r\nHost: h\r\nTransfer-Encoding: chunked\r\n\r\n";
    EXPECT_EQ(ask_raw(chunked + "c9\r\n" + std::string(201, 'v') + "\r\n0\r\n\r\n").status, 413);
}

// What has not arrived holds up nobody, however much was announced.
TEST_F(AssetRoutesTest, SlowUploadsHoldUpNobody) {
    HttpOptions options;
    options.limits.upload_bytes = 100'000;
    start(options);
    std::vector<RawClient> slow;
    for (int i = 0; i < 20; ++i) {
        slow.push_back(connect());
        slow.back().send("PUT /v1/assets/" + digest_ +
                         " HTTP/1.1\r\nHost: h\r\nExpect: 100-continue\r\n"
                         "Content-Length: 50000\r\n\r\nv");
        (void)slow.back().receive_until("\r\n\r\n");  // its head was read
    }
    EXPECT_EQ(put(digest_, kObj).status, 201);
}

// Uploads that have arrived in part take the room of uploads, and of nothing else.
TEST_F(AssetRoutesTest, UploadsOfAClientAreBounded) {
    HttpOptions options;
    options.limits.upload_bytes = 400'000;
    start(options);
    const RawClient first = connect();
    RawClient second = connect();
    const std::string head =
        "PUT /v1/assets/" + digest_ + " HTTP/1.1\r\nHost: h\r\nContent-Length: 300000\r\n\r\n";
    first.send(head + std::string(60'000, 'v'));
    second.send(head + std::string(60'000, 'v'));
    EXPECT_TRUE(first.has_answer() || second.has_answer()) << "its share is 100,000";
    EXPECT_EQ(ask("POST", "/v1/scenes/validate", {}, "{}").status, 200);
}

TEST_F(AssetRoutesTest, ClientsLearnWhatIsMissing) {
    start();
    ASSERT_EQ(put(digest_, kObj).status, 201);
    const std::string other = api::digest_of("other");
    const auto answer = ask("POST", "/v1/assets/missing", {},
                            "{\"digests\":[\"" + other + "\",\"" + digest_ + "\"]}");
    EXPECT_EQ(answer.status, 200);
    EXPECT_EQ(answer.body, "{\"missing\":[\"" + other + "\"]}");
    const auto refused = ask("POST", "/v1/assets/missing", {}, R"({"digests":["x",3],"more":1})");
    EXPECT_TRUE(is_problem(refused, 422, "invalid-document")) << refused.body;
    for (const char* place : {"\"/digests/0\"", "\"/digests/1\"", "\"/more\""})
        EXPECT_NE(refused.body.find(place), std::string::npos) << place;
    std::string many = "{\"digests\":[";
    for (int i = 0; i < 1001; ++i) many += (i == 0 ? "\"" : ",\"") + digest_ + "\"";
    EXPECT_NE(ask("POST", "/v1/assets/missing", {}, many + "]}").body.find("over-limit"),
              std::string::npos);
}

TEST_F(AssetRoutesTest, PagesElsewhereNeedToBeListed) {
    HttpOptions options;
    options.cors_origins = {"https://a.example"};
    start(options);
    const auto foreign =
        ask("PUT", "/v1/assets/" + digest_, {"Origin: https://evil.example"}, kObj);
    EXPECT_TRUE(is_problem(foreign, 403, "origin-not-allowed"));
    const auto preflight = ask("OPTIONS", "/v1/assets/" + digest_,
                               {"Origin: https://a.example", "Access-Control-Request-Method: PUT"});
    EXPECT_NE(preflight.header("access-control-allow-methods").find("PUT"), std::string::npos);
    EXPECT_EQ(ask("PUT", "/v1/assets/" + digest_, {"Origin: https://a.example"}, kObj).status, 201);
}

}  // namespace
}  // namespace bouguer::server::testing
