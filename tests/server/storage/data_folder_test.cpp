// SPDX-License-Identifier: Apache-2.0
#include "server/storage/data_folder.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/server/storage/temporary_folder.h"

namespace bouguer::server {
namespace {

namespace fs = std::filesystem;

class DataFolderTest : public testing::Test {
  protected:
    DataFolderTest() {
        fs::create_directory(data_);
        std::ofstream(file_) << "rows";
    }
    TemporaryFolder folder_;
    fs::path data_ = folder_.path() / "data";
    fs::path file_ = data_ / "jobs.sqlite";
};

TEST_F(DataFolderTest, IsWellWhileNothingChanged) {
    const auto data = DataFolder::open({data_, file_});
    ASSERT_TRUE(data) << data.error().message;
    std::ofstream(file_) << "other rows";
    EXPECT_TRUE(data->check());
}

TEST_F(DataFolderTest, NoticesThatItWasRemoved) {
    const auto data = DataFolder::open({data_, file_});
    fs::remove_all(data_);
    EXPECT_EQ(data->check().error().code, "storage-failed");
}

// What is written to the open file is lost then, however well it goes.
TEST_F(DataFolderTest, NoticesAnotherFileInThePlaceOfItsOwn) {
    const auto data = DataFolder::open({data_, file_});
    fs::rename(file_, data_ / "old");  // keeps the inode, so that the new file has another
    std::ofstream(file_) << "rows";
    EXPECT_EQ(data->check().error().code, "storage-failed");
}

TEST_F(DataFolderTest, IsNotOpenedOnWhatIsMissing) {
    EXPECT_FALSE(DataFolder::open({data_, data_ / "results"}));
}

TEST(DataFolder, KeepsAReserveThatFitsTheDisk) {
    EXPECT_EQ(reserved_bytes(1ULL << 40U), 64U << 20U);
    EXPECT_EQ(reserved_bytes(3U << 20U), (3U << 20U) / 20);
}

}  // namespace
}  // namespace bouguer::server
