// SPDX-License-Identifier: Apache-2.0
#include "server/storage/folder_result_store.h"

#include <fstream>

#include "tests/server/storage/result_store_contract.h"
#include "tests/server/storage/temporary_folder.h"

namespace bouguer::server {
namespace {

struct FolderBackend {
    TemporaryFolder folder;
    std::unique_ptr<ResultStore> make() {
        return std::move(FolderResultStore::open(folder.path() / "results").value());
    }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Folder, ResultStoreContract, FolderBackend);

class FolderResultStoreTest : public testing::Test {
  protected:
    TemporaryFolder folder_;
    std::filesystem::path root_ = folder_.path() / "results";
};

TEST_F(FolderResultStoreTest, KeepsFilesWhenItIsOpenedAgain) {
    ASSERT_TRUE((*FolderResultStore::open(root_))->put(kResultJob, {{"image.png", "abc"}}));
    EXPECT_EQ(
        (*FolderResultStore::open(root_))->get(kResultJob, "image.png")->content.all().value(),
        "abc");
}

TEST_F(FolderResultStoreTest, NoticesDamage) {
    auto store = FolderResultStore::open(root_);
    ASSERT_TRUE(store);
    ASSERT_TRUE((*store)->put(kResultJob, {{"image.png", "abc"}}));
    std::ofstream(root_ / kResultJob / "image.png") << "abd";
    EXPECT_EQ((*store)->get(kResultJob, "image.png").error().code, "result-damaged");
    std::filesystem::remove(root_ / kResultJob / "image.png");
    EXPECT_EQ((*store)->get(kResultJob, "image.png").error().code, "result-damaged");
}

// What a crash before the rename leaves is not seen, and is gone after the next start.
TEST_F(FolderResultStoreTest, ForgetsHalfWrittenResults) {
    const auto part = root_ / (".part-" + kResultJob);
    std::filesystem::create_directories(part);
    std::ofstream(part / "image.png") << "ab";
    auto store = FolderResultStore::open(root_);
    ASSERT_TRUE(store);
    EXPECT_FALSE((*store)->get(kResultJob, "image.png"));
    EXPECT_FALSE(std::filesystem::exists(part));
}

TEST_F(FolderResultStoreTest, SaysWhenItCannotWrite) {
    std::ofstream(folder_.path() / "file") << "x";
    EXPECT_EQ(FolderResultStore::open(folder_.path() / "file" / "results").error().kind,
              ErrorKind::Internal);
    auto store = FolderResultStore::open(root_);
    ASSERT_TRUE(store);
    std::filesystem::remove_all(root_);
    EXPECT_EQ((*store)->put(kResultJob, {{"image.png", "abc"}}).error().kind, ErrorKind::Internal);
}

}  // namespace
}  // namespace bouguer::server
