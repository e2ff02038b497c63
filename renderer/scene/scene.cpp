// SPDX-License-Identifier: Apache-2.0
#include "renderer/scene/scene.h"

#include <utility>

#include "renderer/render.h"
#include "renderer/scene/mend_meshes.h"

namespace bouguer::renderer {
namespace {

using MeshPtr = std::shared_ptr<const TriangleMesh>;

/// Disks are sheets: no inside, so no refraction and no absorption. So is an open mesh of a
/// material that would do neither.
BodyDescription body_of(const ObjectDescription& object, const Shape& shape,
                        const SceneDescription& scene) {
    BodyDescription body;
    body.is_flat = std::holds_alternative<Disk>(shape);
    const MaterialNeeds needs = needs_of(scene.materials[object.material]);
    if (needs.transmits) {
        const auto* mesh = std::get_if<MeshPtr>(&shape);
        body.is_closed = mesh == nullptr || (*mesh)->topology->is_closed;
        const bool is_sheet = body.is_flat || (!body.is_closed && !has_inside(needs));
        body.matter = is_sheet ? Matter::Sheet : Matter::Body;
    }
    body.priority = object.priority;
    body.instances = static_cast<std::uint32_t>(object.placed.instances.size());
    return body;
}

}  // namespace

Result<std::shared_ptr<const Scene>> Scene::build(const SceneDescription& given,
                                                  const GeometryWrapper& wrap) {
    SceneDescription description = given;
    mend_meshes(description);
    std::vector<PlacedShape> shapes;
    shapes.reserve(description.objects.size());
    for (const ObjectDescription& object : description.objects) shapes.push_back(object.placed);
    auto geometry = Geometry::build(shapes);
    if (!geometry) return tl::unexpected(geometry.error());

    std::shared_ptr<Scene> scene(new Scene);
    scene->geometry_ = wrap ? wrap(std::move(*geometry)) : std::move(*geometry);
    scene->camera_ = description.camera;
    scene->materials_ = description.materials;
    scene->environment_ = description.environment;
    scene->ambient_ = description.ambient;
    std::vector<BodyDescription> bodies;
    for (const ObjectDescription& object : description.objects) {
        scene->object_materials_.push_back(static_cast<std::uint32_t>(object.material));
        scene->object_names_.push_back(object.name);
        bodies.push_back(body_of(object, shapes[bodies.size()].shape, description));
        if (const auto* mesh =
                std::get_if<std::shared_ptr<const TriangleMesh>>(&object.placed.shape)) {
            scene->dropped_triangles_ += (*mesh)->dropped_triangles;
            if ((*mesh)->topology)
                scene->dropped_triangles_ += (*mesh)->topology->doubled_triangles;
        }
    }
    scene->bodies_ = std::make_unique<const BodyTable>(bodies, *scene->geometry_);
    const Vec3 origin = scene->geometry_->origin();
    for (const LightDescription& light : description.lights) {
        scene->lights_.push_back(Light::make(light, origin, description.metres_per_unit));
    }
    return scene;
}

Result<std::shared_ptr<const Scene>> build_scene(const SceneDescription& description) {
    return Scene::build(description);
}

}  // namespace bouguer::renderer
