// SPDX-License-Identifier: Apache-2.0
// The scene that rays see: built once from a description, then immutable and shared by any number
// of jobs and threads.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/core/result.h"
#include "renderer/geometry/geometry.h"
#include "renderer/lights/light.h"
#include "renderer/media/body_table.h"
#include "renderer/scene/description.h"

namespace bouguer::renderer {

class Scene {
  public:
    /// Error{InvalidInput}: a scene that only the renderer can judge (see Geometry, Camera).
    /// Error{Internal}: memory.
    /// `wrap`, when given, gets the geometry and may put another around it: a seam for tests and
    /// benchmarks that record or count rays.
    using GeometryWrapper =
        std::function<std::unique_ptr<const Geometry>(std::unique_ptr<const Geometry>)>;
    [[nodiscard]] static Result<std::shared_ptr<const Scene>> build(
        const SceneDescription& description, const GeometryWrapper& wrap = {});

    [[nodiscard]] const Geometry& geometry() const { return *geometry_; }
    [[nodiscard]] const CameraDescription& camera() const { return camera_; }
    [[nodiscard]] const std::vector<MaterialDescription>& materials() const { return materials_; }
    /// Material of every object, by the object's index.
    [[nodiscard]] const std::vector<std::uint32_t>& object_materials() const {
        return object_materials_;
    }
    /// Which objects light goes through, and which counts where they overlap.
    [[nodiscard]] const BodyTable& bodies() const { return *bodies_; }
    /// Of every object, for reports; by the object's index.
    [[nodiscard]] const std::vector<std::string>& object_names() const { return object_names_; }
    [[nodiscard]] const std::vector<Light>& lights() const { return lights_; }
    [[nodiscard]] const std::optional<ConstantEnvironment>& environment() const {
        return environment_;
    }
    [[nodiscard]] const std::optional<AmbientDescription>& ambient() const { return ambient_; }
    [[nodiscard]] std::uint64_t dropped_triangles() const { return dropped_triangles_; }

  private:
    Scene() = default;
    std::unique_ptr<const Geometry> geometry_;
    CameraDescription camera_;
    std::vector<MaterialDescription> materials_;
    std::vector<std::uint32_t> object_materials_;
    std::unique_ptr<const BodyTable> bodies_;
    std::vector<std::string> object_names_;
    std::vector<Light> lights_;
    std::optional<ConstantEnvironment> environment_;
    std::optional<AmbientDescription> ambient_;
    std::uint64_t dropped_triangles_ = 0;
};

}  // namespace bouguer::renderer
