// SPDX-License-Identifier: Apache-2.0
#include "server/storage/folder_asset_source.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "tests/server/storage/temporary_folder.h"

namespace bouguer::server {
namespace {

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

class FolderAssetSourceTest : public testing::Test {
  protected:
    FolderAssetSourceTest() {
        std::filesystem::create_directories(root_ / "parts");
        std::ofstream(root_ / "parts" / "a.obj") << kTriangle;
        std::ofstream(folder_.path() / "secret.obj") << kTriangle;
    }
    ErrorKind refusal(std::string_view name) const {
        const auto bytes = assets_.read(name);
        EXPECT_FALSE(bytes) << name;
        return bytes ? ErrorKind::Busy : bytes.error().kind;
    }

    TemporaryFolder folder_;
    std::filesystem::path root_ = folder_.path() / "assets";
    FolderAssetSource assets_{root_};
};

TEST_F(FolderAssetSourceTest, ReadsFilesBelowItsFolder) {
    const auto bytes = assets_.read("parts/a.obj");
    ASSERT_TRUE(bytes) << bytes.error().message;
    EXPECT_EQ(*bytes, kTriangle);
    EXPECT_TRUE(assets_.read("./parts/a.obj"));
}

TEST_F(FolderAssetSourceTest, RefusesNamesThatLeaveItsFolder) {
    const std::string absolute = (root_ / "parts" / "a.obj").string();
    const std::string long_name(5000, 'a');
    for (const std::string_view name :
         {std::string_view("../secret.obj"), std::string_view("parts/../../secret.obj"),
          std::string_view("parts/../parts/a.obj"), std::string_view(".."), std::string_view(""),
          std::string_view("/etc/passwd"), std::string_view(absolute), std::string_view(long_name),
          std::string_view("parts/a.obj\0.png", 16)}) {
        EXPECT_EQ(refusal(name), ErrorKind::InvalidInput) << name;
    }
}

TEST_F(FolderAssetSourceTest, FollowsLinksOnlyInside) {
    std::filesystem::create_symlink("parts/a.obj", root_ / "inside.obj");
    std::filesystem::create_symlink(folder_.path() / "secret.obj", root_ / "outside.obj");
    std::filesystem::create_directory_symlink("/etc", root_ / "etc");
    EXPECT_TRUE(assets_.read("inside.obj"));
    EXPECT_EQ(refusal("outside.obj"), ErrorKind::NotFound);
    EXPECT_EQ(refusal("etc/passwd"), ErrorKind::NotFound);
}

TEST_F(FolderAssetSourceTest, RefusesWhatIsNoFile) {
    EXPECT_EQ(refusal("missing.obj"), ErrorKind::NotFound);
    EXPECT_EQ(refusal("parts"), ErrorKind::NotFound);
    // A pipe that nobody writes to must not be waited for.
    ASSERT_EQ(mkfifo((root_ / "pipe.obj").c_str(), 0600), 0);
    EXPECT_EQ(refusal("pipe.obj"), ErrorKind::NotFound);
}

TEST_F(FolderAssetSourceTest, RefusesLargeFilesUnread) {
    const FolderAssetSource strict(root_, 10);
    EXPECT_EQ(strict.read("parts/a.obj").error().kind, ErrorKind::TooLarge);
}

TEST(FolderAssetSource, FindsNothingWhenThereIsNoFolder) {
    const FolderAssetSource assets("/nonexistent/folder");
    EXPECT_EQ(assets.read("a.obj").error().kind, ErrorKind::NotFound);
}

}  // namespace
}  // namespace bouguer::server
