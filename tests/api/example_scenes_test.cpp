// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "api/job_document.h"
#include "tests/support/named_bytes.h"
#include "tests/support/source_folder.h"

namespace bouguer::api {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// The files beside a scene.
class FolderAssets final : public tests::NamedBytes {
  public:
    explicit FolderAssets(fs::path folder) : folder_(std::move(folder)) {}
    [[nodiscard]] Result<std::string> bytes(std::string_view name) const override {
        if (!fs::exists(folder_ / name)) return fail(ErrorKind::NotFound, "no such file");
        return text_of(folder_ / name);
    }

  private:
    fs::path folder_;
};

TEST(ExampleScenes, AreAcceptedWithoutAWarning) {
    std::size_t scenes = 0;
    const fs::path root = tests::source_folder() / "client-examples/scenes";
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        if (entry.path().extension() != ".json") continue;
        ++scenes;
        const auto job =
            parse_job(text_of(entry.path()), Limits{}, FolderAssets(entry.path().parent_path()));
        if (job) {
            for (const Warning& w : job->warnings.listed())
                ADD_FAILURE() << entry.path() << ": " << w.pointer << " " << w.detail;
            continue;
        }
        ADD_FAILURE() << entry.path() << ": " << job.error().message;
        for (const Problem& problem : job.error().problems) {
            ADD_FAILURE() << problem.pointer << " " << problem.code << " " << problem.detail;
        }
    }
    EXPECT_GT(scenes, 6U);
}

}  // namespace
}  // namespace bouguer::api
