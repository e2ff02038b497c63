// SPDX-License-Identifier: Apache-2.0
#include "renderer/scene/mend_meshes.h"

#include <gtest/gtest.h>

#include <utility>

#include "renderer/scene/scene.h"
#include "renderer/spectrum/spectra.h"
#include "tests/support/meshes.h"

namespace bouguer::renderer {
namespace {

using MeshPtr = std::shared_ptr<const TriangleMesh>;

MaterialDescription glass() {
    HallMaterial hall;
    hall.k_st = 1;
    hall.ior = constant_spectrum(1.5);
    return {"glass", hall};
}

MeshPtr inside_out() {
    TriangleMesh mesh = *test::cube();
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

SceneDescription scene_of(const std::vector<MeshPtr>& meshes) {
    SceneDescription scene;
    scene.materials = {glass(), {"chalk", HallMaterial{}}};
    for (const MeshPtr& mesh : meshes) {
        ObjectDescription object;
        object.placed.shape = mesh;
        scene.objects.push_back(object);
    }
    return scene;
}

const TriangleMesh& mesh_of(const SceneDescription& scene, std::size_t object) {
    return *std::get<MeshPtr>(scene.objects[object].placed.shape);
}

TEST(MendMeshes, LooksAtAMeshOnceAndOnlyWhereLightGoesIn) {
    const MeshPtr mesh = inside_out();
    SceneDescription scene = scene_of({mesh, mesh, mesh});
    scene.objects[2].material = 1;
    mend_meshes(scene);
    EXPECT_EQ(&mesh_of(scene, 0), &mesh_of(scene, 1));
    EXPECT_TRUE(mesh_of(scene, 0).topology.has_value());
    EXPECT_EQ(&mesh_of(scene, 2), mesh.get());
    const TriangleMesh* mended = &mesh_of(scene, 0);
    mend_meshes(scene);
    EXPECT_EQ(&mesh_of(scene, 0), mended);
}

// A point in a cube of glass is in it, whichever way its triangles wind, and not counted twice.
TEST(Scene, FindsTheInsideOfMeshesThatAreInsideOut) {
    TriangleMesh twice = *test::cube();
    twice.triangles.insert(twice.triangles.end(), twice.triangles.begin(), twice.triangles.end());
    for (const MeshPtr& mesh :
         {test::cube(), inside_out(), MeshPtr(std::make_shared<const TriangleMesh>(twice))}) {
        const auto scene = Scene::build(scene_of({mesh}));
        ASSERT_TRUE(scene);
        EXPECT_EQ((*scene)->bodies().around({0.1, 0.2, 0.3}).count(0), 1U);
        EXPECT_EQ((*scene)->bodies().around({1.1, 0.2, 0.3}).count(0), 0U);
        EXPECT_EQ((*scene)->dropped_triangles(), mesh->triangles.size() - 12);
    }
}

}  // namespace
}  // namespace bouguer::renderer
