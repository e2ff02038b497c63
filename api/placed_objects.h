// SPDX-License-Identifier: Apache-2.0
// Where the objects of a scene stand, as far as can be told without tracing a ray.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "renderer/geometry/analytic_shape.h"
#include "renderer/geometry/bounds.h"
#include "renderer/scene/description.h"

namespace bouguer::api {

/// One instance of an object, in world coordinates.
struct Place {
    std::size_t object = 0, instance = 0;
    renderer::Bounds bounds;                         ///< empty: infinite, a plane
    std::optional<renderer::AnalyticShape> shape{};  ///< convex and closed; else empty
};

/// Every instance of every object, in the order of the scene.
[[nodiscard]] std::vector<Place> places_of(const renderer::SceneDescription& scene);

/// Whether a point lies inside a convex place, farther from its surface than a millionth of its
/// thickness; false for other places.
[[nodiscard]] bool is_around(const Place& place, renderer::Vec3 p);
/// Likewise the whole of a place of `object`. May say no where it is nearer to the surface than a
/// hundredth of its own size, and of meshes that fill their boxes badly.
[[nodiscard]] bool is_around(const Place& place, const renderer::ObjectDescription& object,
                             const Place& other);

/// Twice the volume over the surface of a closed mesh, in its own units: of a shell about its wall.
/// O(n) in triangles.
[[nodiscard]] renderer::Real wall_of(const renderer::TriangleMesh& mesh);

/// The mesh of an object; null for other shapes.
[[nodiscard]] const renderer::TriangleMesh* mesh_of(const renderer::ObjectDescription& object);

/// Whether the object is something without an inside: a disk, or an open mesh of a material that
/// has none. Light goes through it or not. The scene's meshes have been mended.
[[nodiscard]] bool is_sheet(const renderer::SceneDescription& scene,
                            const renderer::ObjectDescription& object);

}  // namespace bouguer::api
