// SPDX-License-Identifier: Apache-2.0
#include "api/placed_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace bouguer::api {
namespace {

using renderer::Bounds;
using renderer::ObjectDescription;
using renderer::Real;
using renderer::SceneDescription;
using renderer::Transform;
using renderer::TriangleMesh;
using renderer::Vec3;

std::array<Vec3, 8> corners_of(const Bounds& box) {
    std::array<Vec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = {(i & 1) != 0 ? box.hi.x : box.lo.x, (i & 2) != 0 ? box.hi.y : box.lo.y,
                      (i & 4) != 0 ? box.hi.z : box.lo.z};
    return corners;
}

Bounds bounds_of(const TriangleMesh& mesh) {
    Bounds bounds;
    for (const Vec3& p : mesh.positions) bounds.add(p);
    return bounds;
}

/// A box around the moved box.
Bounds moved(const Bounds& box, const Transform& by) {
    Bounds bounds;
    if (box.empty()) return bounds;
    for (const Vec3& corner : corners_of(box)) bounds.add(by.point(corner));
    return bounds;
}

/// A polygon of so many corners about a circle of radius 1 reaches out to kReach.
constexpr int kSides = 32;
const Real kReach = 1 / std::cos(renderer::kPi / kSides);

/// The corners of a polygon around the circle.
void add_circle(Vec3 center, Vec3 axis, Real radius, std::vector<Vec3>& points) {
    const renderer::Frame frame(axis);
    for (int i = 0; i < kSides; ++i) {
        const Real angle = 2 * renderer::kPi * i / kSides;
        points.push_back(center +
                         radius * kReach * (std::cos(angle) * frame.x + std::sin(angle) * frame.y));
    }
}

/// Points in the object's own space whose convex hull holds all of the shape; empty for planes,
/// and for meshes, of which the box stands for the hull.
std::vector<Vec3> hull_of(const renderer::Shape& shape) {
    std::vector<Vec3> points;
    if (const auto* sphere = std::get_if<renderer::Sphere>(&shape)) {
        // Meridians through corners of a polygon, from pole to pole.
        const Vec3 up{0, 0, 1};
        for (int i = 0; i <= kSides / 2; ++i) {
            const Real angle = 2 * renderer::kPi * i / kSides;
            const Real radius = kReach * sphere->radius;
            add_circle(sphere->center + radius * std::cos(angle) * up, up, radius * std::sin(angle),
                       points);
        }
    } else if (const auto* cylinder = std::get_if<renderer::Cylinder>(&shape)) {
        const Vec3 axis = normalize(cylinder->to - cylinder->from);
        add_circle(cylinder->from, axis, cylinder->radius, points);
        add_circle(cylinder->to, axis, cylinder->radius, points);
    } else if (const auto* disk = std::get_if<renderer::Disk>(&shape)) {
        add_circle(disk->center, normalize(disk->normal), disk->radius, points);
    } else if (const auto* box = std::get_if<renderer::Box>(&shape)) {
        const auto corners = corners_of({box->min, box->max});
        points.assign(corners.begin(), corners.end());
    }
    return points;
}

}  // namespace

const TriangleMesh* mesh_of(const ObjectDescription& object) {
    const auto* mesh = std::get_if<std::shared_ptr<const TriangleMesh>>(&object.placed.shape);
    return mesh != nullptr ? mesh->get() : nullptr;
}

std::vector<Place> places_of(const SceneDescription& scene) {
    std::vector<Place> places;
    std::map<const TriangleMesh*, Bounds> meshes;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const ObjectDescription& object = scene.objects[i];
        const TriangleMesh* mesh = mesh_of(object);
        const bool is_flat = std::holds_alternative<renderer::Disk>(object.placed.shape);
        if (mesh != nullptr && !meshes.contains(mesh)) meshes.emplace(mesh, bounds_of(*mesh));
        for (std::size_t j = 0; j < object.placed.instances.size(); ++j) {
            const Transform& to_world = object.placed.instances[j];
            Place place{i, j, {}};
            if (mesh != nullptr) place.bounds = moved(meshes[mesh], to_world);
            auto shape = renderer::AnalyticShape::create(object.placed.shape, to_world);
            if (shape) place.bounds = shape->bounds();
            if (shape && !is_flat) place.shape = shape;
            places.push_back(std::move(place));
        }
    }
    return places;
}

bool is_around(const Place& place, Vec3 p) {
    return place.shape && place.shape->contains(p) &&
           !place.shape->touches(p, 1e-6 * place.shape->thinnest());
}

bool is_around(const Place& place, const ObjectDescription& object, const Place& other) {
    if (!place.shape || other.bounds.empty()) return false;
    // Boxes first: they are quick, and most things are not inside each other.
    const Bounds& box = other.bounds;
    if (min(place.bounds.lo, box.lo) != place.bounds.lo) return false;
    if (max(place.bounds.hi, box.hi) != place.bounds.hi) return false;
    const auto holds = [&](Vec3 p) { return is_around(place, p); };
    const std::vector<Vec3> hull = hull_of(object.placed.shape);
    if (hull.empty()) {
        const auto corners = corners_of(box);
        return std::all_of(corners.begin(), corners.end(), holds);
    }
    const Transform& to_world = object.placed.instances[other.instance];
    return std::all_of(hull.begin(), hull.end(), [&](Vec3 p) { return holds(to_world.point(p)); });
}

Real wall_of(const TriangleMesh& mesh) {
    if (mesh.positions.empty()) return 0;
    const Vec3 origin = mesh.positions.front();
    Real volume = 0, area = 0;
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vec3 a = mesh.positions[i] - origin, b = mesh.positions[j] - origin,
                   c = mesh.positions[k] - origin;
        volume += dot(a, cross(b, c)) / 6;
        area += length(cross(b - a, c - a)) / 2;
    }
    return area > 0 ? 2 * std::abs(volume) / area : 0;
}

bool is_sheet(const SceneDescription& scene, const ObjectDescription& object) {
    if (std::holds_alternative<renderer::Disk>(object.placed.shape)) return true;
    const TriangleMesh* mesh = mesh_of(object);
    if (mesh == nullptr || !mesh->topology || mesh->topology->is_closed) return false;
    const auto needs = renderer::needs_of(scene.materials[object.material]);
    return !needs.transmits || !renderer::has_inside(needs);
}

}  // namespace bouguer::api
