// SPDX-License-Identifier: Apache-2.0
#include "server/storage/memory_asset_store.h"

#include "tests/server/storage/asset_store_contract.h"

namespace bouguer::server {
namespace {

struct MemoryBackend {
    std::unique_ptr<AssetStore> make(const AssetStoreLimits& limits) {
        return std::make_unique<MemoryAssetStore>(limits);
    }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Memory, AssetStoreContract, MemoryBackend);

TEST(AssetMediaType, IsToldByTheContent) {
    EXPECT_EQ(asset_media_type("\x89PNG\r\n\x1a\nrest"), "image/png");
    EXPECT_EQ(asset_media_type("\xff\xd8\xff\xe0"), "image/jpeg");
    EXPECT_EQ(asset_media_type("\x76\x2f\x31\x01"), "image/x-exr");
    EXPECT_EQ(asset_media_type(kPlyAsset), "application/x-ply");
    EXPECT_EQ(asset_media_type("\r\n  # by hand\r\n\to thing\r\n"), "model/obj");
    EXPECT_EQ(asset_media_type("# only a comment\n"), "");
}

}  // namespace
}  // namespace bouguer::server
