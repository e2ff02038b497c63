// SPDX-License-Identifier: Apache-2.0
#include "tests/server/http/server_fixture.h"

namespace bouguer::server::testing {
namespace {

using LibraryRoutesTest = ServerTest;

TEST_F(LibraryRoutesTest, ListsWhatDocumentsMayName) {
    start();
    const std::string all = ask("GET", "/v1/library").body;
    for (const char* part :
         {R"("name":"D65")", R"("name":"srgb")", R"("name":"lee-9300k")", R"("type":"hall")",
          R"("name":"diamond")", R"("name":"Cu")", R"("name":"cie2015-10")", R"("name":"rgb")"}) {
        EXPECT_NE(all.find(part), std::string::npos) << part;
    }
    for (const char* part :
         {"spectra", "indices", "metals", "observers", "materials", "displays", "integrators"}) {
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

// Schott's catalogue: N-BK7 has n_d = 1.5168 and v_d = 64.17.
TEST_F(LibraryRoutesTest, IndicesHaveTheirCatalogueNumbers) {
    start();
    const auto response = ask("GET", "/v1/library/indices/N-BK7");
    EXPECT_EQ(response.status, 200);
    EXPECT_NE(response.body.find(R"("n_d":1.5168)"), std::string::npos) << response.body;
    EXPECT_NE(response.body.find(R"("v_d":64.1)"), std::string::npos);
    EXPECT_NE(response.body.find(R"("values":[1.5)"), std::string::npos);
}

TEST_F(LibraryRoutesTest, MetalsHaveNAndKAndObserversXyz) {
    start();
    const std::string copper = ask("GET", "/v1/library/metals/Cu").body;
    EXPECT_NE(copper.find(R"("n":[)"), std::string::npos);
    EXPECT_NE(copper.find(R"("k":[)"), std::string::npos);
    const std::string observer = ask("GET", "/v1/library/observers/cie1931-2").body;
    EXPECT_NE(observer.find(R"("wavelengths_nm":[360,361,)"), std::string::npos);
    for (const char* key : {R"("x":[)", R"("y":[)", R"("z":[)"}) {
        EXPECT_NE(observer.find(key), std::string::npos) << key;
    }
}

TEST_F(LibraryRoutesTest, TransmittancesTellTheirThicknessAndDisplaysTheirCorners) {
    start();
    const std::string spectra = ask("GET", "/v1/library/spectra").body;
    EXPECT_NE(spectra.find(R"("thickness_mm":10)"), std::string::npos);
    // IEC 61966-2-1
    EXPECT_NE(ask("GET", "/v1/library/displays").body.find(R"("red":[0.64,0.33])"),
              std::string::npos);
}

TEST_F(LibraryRoutesTest, EverythingOverWavelengthHasAPlot) {
    start();
    const std::string signature = "\x89PNG\r\n\x1a\n";
    for (const char* path : {"spectra/D65", "spectra/SF11-10mm", "indices/diamond", "metals/brass",
                             "observers/cie2015-2"}) {
        const auto plot = ask("GET", std::string("/v1/library/") + path + ".png");
        EXPECT_EQ(plot.status, 200) << path;
        EXPECT_EQ(plot.header("content-type"), "image/png") << path;
        EXPECT_TRUE(plot.body.starts_with(signature)) << path;
        const auto accepted = ask("GET", std::string("/v1/library/") + path, {"Accept: image/png"});
        EXPECT_EQ(accepted.body, plot.body) << path;
        EXPECT_EQ(accepted.header("vary"), "Accept");
        EXPECT_EQ(ask("GET", std::string("/v1/library/") + path + ".png",
                      {"If-None-Match: " + plot.header("etag")})
                      .status,
                  304);
    }
    EXPECT_TRUE(is_problem(ask("GET", "/v1/library/spectra/D65", {"Accept: text/html"}), 406,
                           "not-acceptable"));
    for (const char* path :
         {"spectra/D66.png", "spectra/.png", "indices/D65.png", "materials/hall"}) {
        EXPECT_TRUE(is_problem(ask("GET", std::string("/v1/library/") + path), 404, "not-found"))
            << path;
    }
}

}  // namespace
}  // namespace bouguer::server::testing
