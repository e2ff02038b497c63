// SPDX-License-Identifier: Apache-2.0
#include "server/storage/folder_asset_store.h"

#include <fstream>
#include <iterator>

#include "server/storage/folder_asset_source.h"
#include "tests/server/storage/asset_store_contract.h"
#include "tests/server/storage/temporary_folder.h"

namespace bouguer::server {
namespace {

namespace fs = std::filesystem;

struct FolderBackend {
    std::unique_ptr<AssetStore> make(const AssetStoreLimits& limits) {
        const fs::path root = folder.path() / std::to_string(++stores);
        return std::move(FolderAssetStore::open(root, limits).value());
    }
    TemporaryFolder folder;
    int stores = 0;
};

INSTANTIATE_TYPED_TEST_SUITE_P(Folder, AssetStoreContract, FolderBackend);

class FolderAssetStoreTest : public testing::Test {
  protected:
    std::unique_ptr<FolderAssetStore> open(const AssetStoreLimits& limits = {}) {
        return std::move(FolderAssetStore::open(root_, limits).value());
    }
    [[nodiscard]] std::ptrdiff_t num_files() const {
        return std::distance(fs::directory_iterator(root_), {});
    }

    TemporaryFolder folder_;
    fs::path root_ = folder_.path() / "assets";
    const std::string digest_ = api::digest_of(kObjAsset);
};

TEST_F(FolderAssetStoreTest, KeepsFilesAcrossAStartAndScenesFindThem) {
    ASSERT_TRUE(open()->put(digest_, kObjAsset));
    EXPECT_EQ(num_files(), 1);
    EXPECT_EQ(open()->get(digest_), kObjAsset);
    EXPECT_EQ(FolderAssetSource("/nonexistent", root_).read(digest_), kObjAsset);
}

// What a crash in the middle leaves is not seen, and is gone after the next start.
TEST_F(FolderAssetStoreTest, ForgetsHalfWrittenFiles) {
    fs::create_directories(root_);
    std::ofstream(root_ / ".part-asset-1-1") << "v 0 0";
    std::ofstream(root_ / "chair.obj") << kObjAsset;  // somebody else's
    const auto store = open();
    EXPECT_EQ(num_files(), 1);
    EXPECT_FALSE(store->has(digest_));
}

TEST_F(FolderAssetStoreTest, CountsWhatItFinds) {
    ASSERT_TRUE(open()->put(digest_, kObjAsset));
    const auto store = open({.total_bytes = kObjAsset.size() + 1});
    EXPECT_EQ(store->put(api::digest_of(kPlyAsset), kPlyAsset).error().code, "asset-store-full");
}

TEST_F(FolderAssetStoreTest, NoticesDamageAndChangesNothing) {
    const auto store = open();
    ASSERT_TRUE(store->put(digest_, kObjAsset));
    std::ofstream(root_ / digest_) << "v 1 1 1\n";
    EXPECT_EQ(store->get(digest_).error().code, "asset-damaged");
    EXPECT_EQ(store->put(digest_, kObjAsset), AssetStore::Put::Known);
}

TEST_F(FolderAssetStoreTest, SaysWhenItCannotWrite) {
    const auto store = open();
    fs::remove_all(root_);
    EXPECT_EQ(store->put(digest_, kObjAsset).error().kind, ErrorKind::Internal);
    std::ofstream(folder_.path() / "file") << "x";
    EXPECT_EQ(FolderAssetStore::open(folder_.path() / "file" / "assets").error().kind,
              ErrorKind::Internal);
}

}  // namespace
}  // namespace bouguer::server
