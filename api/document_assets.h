// SPDX-License-Identifier: Apache-2.0
// The files of one document, each read once however often it is named.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "api/job_document.h"

namespace bouguer::api {

/// In front of another source for as long as one document is read: ten thousand objects that name
/// one file share one mesh. Not thread-safe, unlike what it asks.
class DocumentAssets final : public AssetSource {
  public:
    explicit DocumentAssets(const AssetSource& source) : source_(source) {}

    [[nodiscard]] Result<std::shared_ptr<const renderer::TriangleMesh>> mesh(
        std::string_view name) const override {
        const auto known = meshes_.find(name);
        if (known != meshes_.end()) return known->second;
        return meshes_.emplace(name, source_.mesh(name)).first->second;
    }

  private:
    const AssetSource& source_;
    mutable std::map<std::string, Result<std::shared_ptr<const renderer::TriangleMesh>>,
                     std::less<>>
        meshes_;
};

}  // namespace bouguer::api
