// SPDX-License-Identifier: Apache-2.0
#include "server/http/routes/web_routes.h"

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "server/web/web_assets.h"
#include "tests/server/http/server_fixture.h"
#include "tests/support/source_folder.h"

namespace bouguer::server::testing {
namespace {

using WebRoutesTest = ServerTest;

/// Every first group of `pattern` in `text`.
std::set<std::string> all_matches(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern);
    std::set<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it) {
        found.insert((*it)[1]);
    }
    return found;
}

/// A path with its {shelf}, {name}, {digest} and {id} filled in.
std::string with_names(const std::string& path) {
    std::string named = std::regex_replace(path, std::regex("\\{name\\}"), "D65");
    named = std::regex_replace(named, std::regex("\\{shelf\\}"), "spectra");
    named = std::regex_replace(named, std::regex("\\{digest\\}"), "sha256-" + std::string(64, '0'));
    return std::regex_replace(named, std::regex("\\{id\\}"),
                              "01890000-0000-7000-8000-000000000001");
}

std::string text_of_folder(const std::string& folder) {
    std::ostringstream all;
    const auto root = tests::source_folder() / folder;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
        if (entry.path().extension() == ".cpp") all << std::ifstream(entry.path()).rdbuf();
    }
    return all.str();
}

TEST_F(WebRoutesTest, EveryAssetIsServedWithItsTypeAndGuard) {
    start();
    for (const WebAsset& asset : web_assets()) {
        const auto response = ask("GET", asset.path);
        EXPECT_EQ(response.status, 200) << asset.path;
        EXPECT_EQ(response.header("content-type"), asset.media_type);
        EXPECT_FALSE(asset.media_type.empty()) << asset.path;
        EXPECT_EQ(response.body, asset.bytes);
        EXPECT_EQ(response.header("content-security-policy").find("unsafe"), std::string::npos);
        EXPECT_EQ(response.header("content-security-policy").rfind("default-src 'none'", 0), 0U);
    }
    EXPECT_TRUE(is_problem(ask("GET", "/docs/nothing"), 404, "not-found"));
    EXPECT_TRUE(is_problem(ask("GET", "/appXjs"), 404, "not-found"));
}

// The policy forbids both: a page with either would break in the browser only.
TEST(WebAssets, HaveNoScriptOrStyleInside) {
    for (const WebAsset& asset : web_assets()) {
        if (asset.media_type.rfind("text/html", 0) != 0) continue;
        const std::string text(asset.bytes);
        EXPECT_TRUE(all_matches(text, "(<script(?![^>]*src=))").empty()) << asset.path;
        EXPECT_TRUE(all_matches(text, "(<style|\\sstyle=|\\son[a-z]+=)").empty()) << asset.path;
    }
}

TEST_F(WebRoutesTest, LinksLeadSomewhere) {
    start();
    for (const WebAsset& asset : web_assets()) {
        if (asset.media_type.rfind("text/html", 0) != 0) continue;
        for (const std::string& target :
             all_matches(std::string(asset.bytes), "(?:href|src)=\"(/[^\"#]*)")) {
            EXPECT_EQ(ask("GET", target).status, 200) << asset.path << " -> " << target;
        }
    }
}

TEST_F(WebRoutesTest, EveryCallOfTheDocumentationExists) {
    start();
    const auto calls =
        all_matches(ask("GET", "/docs").body, "<code>((?:GET|POST|DELETE) /[^< ]*)</code>");
    EXPECT_GE(calls.size(), 20U);
    for (const std::string& call : calls) {
        const auto space = call.find(' ');
        const auto allowed = ask("OPTIONS", with_names(call.substr(space + 1))).header("allow");
        EXPECT_NE(allowed.find(call.substr(0, space)), std::string::npos) << call;
    }
}

TEST_F(WebRoutesTest, EveryPathOfTheDescriptionExists) {
    start();
    const std::string json = ask("GET", "/v1/openapi.json").body;
    EXPECT_NE(json.find("\"openapi\""), std::string::npos);
    const auto paths = all_matches(json, R"re("(/(?:v1|livez|readyz)[^" ]*)"\s*:)re");
    EXPECT_GE(paths.size(), 15U);
    for (const std::string& path : paths) {
        EXPECT_EQ(ask("OPTIONS", with_names(path)).status, 204) << path;
    }
}

TEST_F(WebRoutesTest, EveryProblemCodeIsExplained) {
    start();
    const std::string page = ask("GET", "/docs/problems").body;
    const std::string http = text_of_folder("server/http");
    std::set<std::string> codes =
        all_matches(http, "(?:Refusal|refuse\\()?[{(]\\s*[45]\\d\\d,\\s*\"([a-z-]+)\"");
    codes.merge(
        all_matches(text_of_folder("api"), "KindEntry\\{ErrorKind::\\w+, \\d+, \"([a-z-]+)\""));
    EXPECT_GE(codes.size(), 20U);
    for (const std::string& code : codes) {
        EXPECT_NE(page.find("<dt id=\"" + code + "\">"), std::string::npos) << code;
    }
}

// The codes inside `errors` are the contract's own list.
TEST_F(WebRoutesTest, EveryCodeOfADocumentsProblemsIsExplained) {
    start();
    const std::string page = ask("GET", "/docs/problems").body;
    std::ostringstream text;
    text << std::ifstream(tests::source_folder() / "api/openapi.yaml").rdbuf();
    const std::string contract = text.str();
    const std::size_t begin = contract.find("    DocumentProblem:");
    ASSERT_NE(begin, std::string::npos);
    const std::string list = contract.substr(begin, contract.find("detail:", begin) - begin);
    const std::set<std::string> codes = all_matches(list, "\n            - ([a-z0-9-]+)");
    EXPECT_GE(codes.size(), 20U);
    for (const std::string& code : codes) {
        EXPECT_NE(page.find("<dt id=\"" + code + "\">"), std::string::npos) << code;
    }
}

TEST_F(WebRoutesTest, EveryWarningIsExplained) {
    start();
    const std::string page = ask("GET", "/docs/warnings").body;
    // After the pointer, which may be a text or a choice of two.
    std::set<std::string> codes = all_matches(
        text_of_folder("api"), R"re(warn\([^";]*(?:"/[^"]*"[^";]*)*"([a-z]+(?:-[a-z]+)+)")re");
    codes.merge(all_matches(text_of_folder("renderer"), "add\\(\\{\"\",\\s*\"([a-z-]+)\""));
    EXPECT_GE(codes.size(), 25U);
    for (const std::string& code : codes) {
        EXPECT_NE(page.find("<dt id=\"" + code + "\">"), std::string::npos) << code;
    }
}

}  // namespace
}  // namespace bouguer::server::testing
