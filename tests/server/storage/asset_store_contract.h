// SPDX-License-Identifier: Apache-2.0
// What every AssetStore must do. A backend joins as with job_store_contract.h.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <thread>
#include <vector>

#include "api/digest.h"
#include "server/storage/asset_store.h"

namespace bouguer::server {

inline const std::string kObjAsset = "# a triangle\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
inline const std::string kPlyAsset("ply\nformat ascii 1.0\n\0\xff", 23);

template <class Backend>
class AssetStoreContract : public testing::Test {
  protected:
    Backend backend_;
    std::unique_ptr<AssetStore> store_ = backend_.make({});
};
TYPED_TEST_SUITE_P(AssetStoreContract);

TYPED_TEST_P(AssetStoreContract, GivesBackWhatWasPut) {
    const std::string digest = api::digest_of(kPlyAsset);
    EXPECT_FALSE(this->store_->has(digest));
    EXPECT_EQ(this->store_->get(digest).error().kind, ErrorKind::NotFound);
    EXPECT_EQ(this->store_->put(digest, kPlyAsset), AssetStore::Put::New);
    EXPECT_TRUE(this->store_->has(digest));
    EXPECT_EQ(this->store_->get(digest), kPlyAsset);
}

TYPED_TEST_P(AssetStoreContract, KnowsWhatWasPutBefore) {
    const std::string digest = api::digest_of(kObjAsset);
    EXPECT_EQ(this->store_->put(digest, kObjAsset), AssetStore::Put::New);
    EXPECT_EQ(this->store_->put(digest, kObjAsset), AssetStore::Put::Known);
}

TYPED_TEST_P(AssetStoreContract, RefusesAnotherDigestAndNamesBoth) {
    const std::string wrong = api::digest_of(kPlyAsset), right = api::digest_of(kObjAsset);
    const auto refused = this->store_->put(wrong, kObjAsset);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, "digest-mismatch");
    EXPECT_NE(refused.error().message.find(wrong), std::string::npos);
    EXPECT_NE(refused.error().message.find(right), std::string::npos);
    EXPECT_FALSE(this->store_->has(wrong) || this->store_->has(right));
}

TYPED_TEST_P(AssetStoreContract, RefusesWhatScenesCannotUse) {
    for (const std::string bytes : {"", "GIF89a", "<html>", "#!/bin/sh\n", "version 1\n"}) {
        const auto refused = this->store_->put(api::digest_of(bytes), bytes);
        ASSERT_FALSE(refused) << bytes;
        EXPECT_EQ(refused.error().code, "unknown-type") << bytes;
    }
}

TYPED_TEST_P(AssetStoreContract, RefusesNamesThatAreNoDigests) {
    for (const std::string name : {"", "..", "../x", "sha256-12", "/etc/passwd"}) {
        EXPECT_FALSE(this->store_->put(name, kObjAsset)) << name;
        EXPECT_FALSE(this->store_->has(name)) << name;
        EXPECT_EQ(this->store_->get(name).error().kind, ErrorKind::NotFound) << name;
    }
}

TYPED_TEST_P(AssetStoreContract, HasItsLimits) {
    const auto small = this->backend_.make({.file_bytes = kObjAsset.size() - 1});
    EXPECT_EQ(small->put(api::digest_of(kObjAsset), kObjAsset).error().kind, ErrorKind::TooLarge);
    const auto full = this->backend_.make({.total_bytes = kObjAsset.size() + 1});
    EXPECT_EQ(full->put(api::digest_of(kObjAsset), kObjAsset), AssetStore::Put::New);
    EXPECT_EQ(full->put(api::digest_of(kPlyAsset), kPlyAsset).error().code, "asset-store-full");
    EXPECT_EQ(full->put(api::digest_of(kObjAsset), kObjAsset), AssetStore::Put::Known);
}

TYPED_TEST_P(AssetStoreContract, ManyMayPutTheSame) {
    const std::string digest = api::digest_of(kObjAsset);
    std::atomic<int> first{0};
    {
        std::vector<std::jthread> threads;
        for (int t = 0; t < 8; ++t)
            threads.emplace_back([&] {
                const auto put = this->store_->put(digest, kObjAsset);
                EXPECT_TRUE(put);
                if (put == AssetStore::Put::New) ++first;
            });
    }
    EXPECT_EQ(first, 1);
    EXPECT_EQ(this->store_->get(digest), kObjAsset);
}

REGISTER_TYPED_TEST_SUITE_P(AssetStoreContract, GivesBackWhatWasPut, KnowsWhatWasPutBefore,
                            RefusesAnotherDigestAndNamesBoth, RefusesWhatScenesCannotUse,
                            RefusesNamesThatAreNoDigests, HasItsLimits, ManyMayPutTheSame);

}  // namespace bouguer::server
