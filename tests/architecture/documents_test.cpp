// SPDX-License-Identifier: Apache-2.0
// The README says what the code says: every limit of a request has its row, with its name and
// value's place in the header, and every path of the contract is named.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "tests/support/source_folder.h"

namespace bouguer::tests {
namespace {

std::string text_of(const std::string& path) {
    std::ifstream in(source_folder() / path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// First groups of all matches, each once.
std::set<std::string> all_matches(const std::string& text, const std::regex& pattern) {
    std::set<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
        found.insert((*it)[1]);
    }
    return found;
}

TEST(Readme, HasARowForEveryLimit) {
    const std::string readme = text_of("README.md");
    const auto limits = all_matches(text_of("api/limits.h"), std::regex(R"( (\w+) = [^;\n]+;)"));
    EXPECT_GT(limits.size(), 15U);
    for (const std::string& limit : limits) {
        EXPECT_NE(readme.find("| `" + limit + "`"), std::string::npos) << limit;
    }
}

TEST(Readme, NamesEveryPathOfTheContract) {
    const std::string readme = text_of("README.md");
    const auto paths = all_matches(text_of("api/openapi.yaml"), std::regex(R"(\n  (/[^\s:]*):)"));
    EXPECT_GT(paths.size(), 8U);
    for (const std::string& path : paths) {
        EXPECT_NE(readme.find(path), std::string::npos) << path;
    }
}

}  // namespace
}  // namespace bouguer::tests
