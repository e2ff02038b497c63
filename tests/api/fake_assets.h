// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string_view>

#include "api/job_document.h"

namespace bouguer::tests {

/// Has one file, "triangle.ply", one that is no mesh, "noise.ply", and one on a broken disk,
/// "broken.ply".
class FakeAssets final : public api::AssetSource {
  public:
    [[nodiscard]] Result<std::shared_ptr<const renderer::TriangleMesh>> mesh(
        std::string_view name) const override {
        if (name == "noise.ply") {
            return tl::unexpected(
                Error{ErrorKind::InvalidInput,
                      "not a mesh",
                      {{"/line/3", "not-a-number", "line 3 is no vertex", {}, {}}},
                      {}});
        }
        if (name == "broken.ply") return fail(ErrorKind::Internal, "the disk does not answer");
        if (name != "triangle.ply") return fail(ErrorKind::NotFound, "no such file");
        auto mesh = std::make_shared<renderer::TriangleMesh>();
        mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        mesh->triangles = {{0, 1, 2}};
        return mesh;
    }
};

}  // namespace bouguer::tests
