// SPDX-License-Identifier: Apache-2.0
#include "server/jobs/scene_cache.h"

#include <gtest/gtest.h>

#include <thread>

#include "renderer/scene/scene.h"

namespace bouguer::server {
namespace {

class SceneCacheTest : public testing::Test {
  protected:
    Result<SceneCache::Scene> get(const std::string& key, std::uint64_t bytes = 1) {
        return cache_.get(key, bytes, [this]() -> Result<SceneCache::Scene> {
            ++builds_;
            return renderer::build_scene({});
        });
    }
    SceneCache cache_{10};
    std::atomic<int> builds_ = 0;
};

TEST_F(SceneCacheTest, BuildsAScene) {
    const auto a = get("a");
    ASSERT_TRUE(a);
    EXPECT_EQ(get("a").value(), *a);
    EXPECT_EQ(builds_, 1);
    EXPECT_NE(get("b").value(), *a);
    EXPECT_EQ(builds_, 2);
}

TEST_F(SceneCacheTest, ForgetsWhatWasUsedLongestAgo) {
    (void)get("a", 4);
    (void)get("b", 4);
    (void)get("a", 4);
    (void)get("c", 4);  // 12 bytes: b goes
    (void)get("a", 4);
    EXPECT_EQ(builds_, 3);
    (void)get("b", 4);
    EXPECT_EQ(builds_, 4);
}

TEST_F(SceneCacheTest, KeepsNoErrors) {
    const auto refused = cache_.get("a", 1, []() -> Result<SceneCache::Scene> {
        return fail(ErrorKind::Internal, "out of memory");
    });
    EXPECT_FALSE(refused);
    EXPECT_TRUE(get("a"));
}

TEST_F(SceneCacheTest, ThreadsThatWantTheSameSceneShareOneBuild) {
    {
        std::vector<std::jthread> threads;
        for (int t = 0; t < 4; ++t) threads.emplace_back([&] { EXPECT_TRUE(get("a")); });
    }
    EXPECT_EQ(builds_, 1);
}

// The document is the same and the file that it names has changed.
TEST(SceneKey, KnowsTheContentOfFiles) {
    const auto job_with = [](std::string files_digest) {
        api::JobRequest job;
        job.scene_digest = "sha256-aa";
        job.files_digest = std::move(files_digest);
        return job;
    };
    EXPECT_EQ(scene_key(job_with("sha256-bb")), scene_key(job_with("sha256-bb")));
    EXPECT_NE(scene_key(job_with("sha256-bb")), scene_key(job_with("sha256-cc")));
}

}  // namespace
}  // namespace bouguer::server
