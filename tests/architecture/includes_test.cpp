// SPDX-License-Identifier: Apache-2.0
// The arrows of the design: renderer <- api <- server, and one third-party library, one room.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>

#include "tests/architecture/include_rules.h"
#include "tests/support/source_folder.h"

namespace bouguer::tests {
namespace {

namespace fs = std::filesystem;

bool is_source(const fs::path& file) {
    const auto extension = file.extension();
    return extension == ".h" || extension == ".cpp";
}

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// Every source of the repository.
TEST(Includes, FollowTheLayersAndTheRooms) {
    const fs::path root = source_folder();
    int sources = 0;
    for (const char* folder : {"renderer", "api", "server", "tests"}) {
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            if (!entry.is_regular_file() || !is_source(entry.path())) continue;
            ++sources;
            const std::string path = fs::relative(entry.path(), root).generic_string();
            for (const std::string& problem : broken_rules(path, text_of(entry.path()))) {
                ADD_FAILURE() << problem;
            }
        }
    }
    EXPECT_GT(sources, 30) << "found no sources to read below " << root;
}

struct Case {
    const char* path;
    const char* include;
};

/// Names a case in ctest's list.
void PrintTo(const Case& c, std::ostream* out) { *out << c.path << " with " << c.include; }

class ForbiddenInclude : public testing::TestWithParam<Case> {};
TEST_P(ForbiddenInclude, IsFound) {
    const auto [path, include] = GetParam();
    EXPECT_EQ(broken_rules(path, std::string("// text\n") + include + "\n").size(), 1U);
}
INSTANTIATE_TEST_SUITE_P(
    Includes, ForbiddenInclude,
    testing::Values(Case{"renderer/core/x.h", "#include \"api/limits.h\""},
                    Case{"renderer/core/x.h", "#include \"server/jobs/job.h\""},
                    Case{"renderer/core/x.h", "#include \"x.h\""},
                    Case{"api/x.cpp", "#  include \"server/jobs/job.h\""},
                    Case{"api/x.cpp", "#include <thread>"},
                    Case{"api/x.cpp", "#include <sys/socket.h>"},
                    Case{"api/x.cpp", "#include <openssl/evp.h>"},
                    Case{"renderer/integrators/x.cpp", "#include <embree3/rtcore.h>"},
                    Case{"renderer/integrators/x.cpp", "#include <embree4/rtcore.h>"},
                    Case{"server/jobs/x.cpp", "#include <OpenImageIO/imageio.h>"},
                    Case{"server/jobs/x.cpp", "#include <nlohmann/json.hpp>"},
                    Case{"server/jobs/x.cpp", "#include <httplib.h>"},
                    Case{"server/jobs/x.cpp", "#include <SQLiteCpp/SQLiteCpp.h>"},
                    Case{"server/jobs/x.cpp", "#include <sqlite3.h>"},
                    Case{"server/jobs/x.cpp", "#include <CLI/CLI.hpp>"},
                    Case{"api/x.cpp", "#include <spdlog/spdlog.h>"},
                    Case{"tests/renderer/x_test.cpp", "#include \"server/jobs/job.h\""},
                    Case{"tests/renderer/x_test.cpp", "#include <nlohmann/json.hpp>"}));

class AllowedInclude : public testing::TestWithParam<Case> {};
TEST_P(AllowedInclude, IsLeftAlone) {
    const auto [path, include] = GetParam();
    EXPECT_EQ(broken_rules(path, std::string(include) + "\n").size(), 0U);
}
INSTANTIATE_TEST_SUITE_P(
    Includes, AllowedInclude,
    testing::Values(Case{"renderer/film/x.cpp", "#include <OpenImageIO/imageio.h>"},
                    Case{"renderer/textures/x.cpp", "#include <OpenImageIO/imageio.h>"},
                    Case{"renderer/geometry/x.cpp", "#include <embree3/rtcore.h>"},
                    Case{"api/x.cpp", "#include \"renderer/render.h\""},
                    Case{"api/digest.cpp", "#include <openssl/evp.h>"},
                    Case{"server/jobs/x.cpp", "#include <thread>"},
                    Case{"server/jobs/x.cpp", "#include <spdlog/spdlog.h>"},
                    Case{"server/jobs/x.cpp", "// #include <httplib.h>"},
                    Case{"tests/server/x_test.cpp", "#include <nlohmann/json.hpp>"},
                    Case{"tests/api/x_test.cpp", "#include \"tests/api/helper.h\""}));

// Line numbers count from 1; blanks may stand around '#', and only real includes count.
TEST(Includes, AreReadFromTheText) {
    const auto found = includes_of("#pragma once\n # include <a/b.h>  // why\n#include \"c.h\"\n");
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].line, 2);
    EXPECT_FALSE(found[0].quoted);
    EXPECT_EQ(found[0].path, "a/b.h");
    EXPECT_TRUE(found[1].quoted);
    EXPECT_EQ(found[1].path, "c.h");
}

}  // namespace
}  // namespace bouguer::tests
