// SPDX-License-Identifier: Apache-2.0
#include "renderer/scene/mend_meshes.h"

#include <map>

#include "renderer/geometry/mesh_topology.h"

namespace bouguer::renderer {

void mend_meshes(SceneDescription& scene) {
    using MeshPtr = std::shared_ptr<const TriangleMesh>;
    std::map<MeshPtr, MeshPtr> mended;
    for (ObjectDescription& object : scene.objects) {
        auto* mesh = std::get_if<MeshPtr>(&object.placed.shape);
        if (mesh == nullptr || !*mesh) continue;
        if (!needs_of(scene.materials[object.material]).transmits) continue;
        MeshPtr& result = mended[*mesh];
        if (!result) result = mended_mesh(*mesh);
        *mesh = result;
    }
}

}  // namespace bouguer::renderer
