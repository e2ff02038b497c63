// SPDX-License-Identifier: Apache-2.0
// Scenes that were built, so that jobs on the same scene share one.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>

#include "api/job_document.h"
#include "renderer/render.h"

namespace bouguer::server {

/// What names the content of a job's scene: its digest and that of the files that it names by a
/// path, which may change while the document stays.
[[nodiscard]] std::string scene_key(const api::JobRequest& job);

/// Keeps the scenes used last, up to a size. Running jobs hold theirs beside it. Thread-safe.
class SceneCache {
  public:
    using Scene = std::shared_ptr<const renderer::Scene>;
    using Build = std::function<Result<Scene>()>;

    explicit SceneCache(std::uint64_t max_bytes) : max_bytes_(max_bytes) {}

    /// The scene of that key; calls `build` if there is none. Of several threads that want the same
    /// scene one builds and the others wait for it. Errors are not kept: the next one tries again.
    [[nodiscard]] Result<Scene> get(const std::string& key, std::uint64_t bytes,
                                    const Build& build);

  private:
    struct Entry {
        std::string key;
        std::uint64_t bytes;
        std::mutex building;  ///< held by the thread that builds
        Scene scene;          ///< guarded by building
    };
    [[nodiscard]] std::shared_ptr<Entry> use(const std::string& key, std::uint64_t bytes);

    const std::uint64_t max_bytes_;
    std::mutex mutex_;
    std::list<std::shared_ptr<Entry>> entries_;  // guarded by mutex_; newest use first
};

}  // namespace bouguer::server
