// SPDX-License-Identifier: Apache-2.0
#include "tests/server/http/server_fixture.h"

namespace bouguer::server::testing {
namespace {

using LibraryRoutesTest = ServerTest;

TEST_F(LibraryRoutesTest, ListsWhatDocumentsMayName) {
    start();
    const std::string all = ask("GET", "/v1/library").body;
    for (const char* part :
         {R"("name":"D65")", R"("name":"srgb")", R"("name":"lee-9300k")", R"("type":"hall")"}) {
        EXPECT_NE(all.find(part), std::string::npos) << part;
    }
    for (const char* part : {"spectra", "materials", "displays"}) {
        const auto response = ask("GET", std::string("/v1/library/") + part);
        EXPECT_EQ(response.status, 200) << part;
        EXPECT_NE(all.find(response.body), std::string::npos) << part;
    }
}

TEST_F(LibraryRoutesTest, ASpectrumHasItsValuesEvery5nm) {
    start();
    const auto response = ask("GET", "/v1/library/spectra/E");
    EXPECT_EQ(response.status, 200);
    EXPECT_NE(response.body.find(R"("wavelengths_nm":[360,365,370,)"), std::string::npos);
    EXPECT_NE(response.body.find("825,830]"), std::string::npos);
    // the equal-energy illuminant: 1 everywhere, at (830 - 360) / 5 + 1 = 95 wavelengths
    std::string ones = "1";
    for (int i = 1; i < 95; ++i) ones += ",1";
    EXPECT_NE(response.body.find("\"values\":[" + ones + "]"), std::string::npos);
    EXPECT_EQ(
        ask("GET", "/v1/library/spectra/E", {"If-None-Match: " + response.header("etag")}).status,
        304);
}

TEST_F(LibraryRoutesTest, UnknownSpectraAreNotFound) {
    start();
    for (const char* name : {"nothing", "%2e%2e%2fetc", "D65%00"}) {
        EXPECT_TRUE(
            is_problem(ask("GET", std::string("/v1/library/spectra/") + name), 404, "not-found"))
            << name;
    }
}

}  // namespace
}  // namespace bouguer::server::testing
