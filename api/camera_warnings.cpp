// SPDX-License-Identifier: Apache-2.0
#include "api/camera_warnings.h"

#include <algorithm>
#include <array>
#include <variant>

#include "renderer/cameras/camera.h"

namespace bouguer::api {
namespace {

using renderer::Bounds;
using renderer::ObjectDescription;
using renderer::Ray;
using renderer::Real;
using renderer::SceneDescription;
using renderer::Vec3;

/// Points p with dot(n, p - o) >= 0.
struct HalfSpace {
    Vec3 o, n;
    /// Whether a box has no point in it.
    [[nodiscard]] bool excludes(const Bounds& box) const {
        const Vec3 farthest{n.x > 0 ? box.hi.x : box.lo.x, n.y > 0 ? box.hi.y : box.lo.y,
                            n.z > 0 ? box.hi.z : box.lo.z};
        return dot(n, farthest - o) < 0;
    }
};

/// What a camera may see: between the rays through the corners of its film.
class View {
  public:
    /// Rays in order round the film, and one through its middle.
    View(const std::array<Ray, 4>& corners, const Ray& middle) : corners_(corners) {
        sides_[0] = {middle.o, middle.d};
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Ray& a = corners[i];
            const Ray& b = corners[(i + 1) % corners.size()];
            // The side lies along both rays: of parallel ones, along what is between them.
            Vec3 n = cross(a.d, b.o == a.o ? b.d : b.o - a.o);
            if (dot(n, middle.at(1) - a.o) < 0) n = -n;
            sides_[i + 1] = {a.o, n};
        }
    }

    [[nodiscard]] bool excludes(const Bounds& box) const {
        return std::any_of(sides_.begin(), sides_.end(),
                           [&](const HalfSpace& side) { return side.excludes(box); });
    }
    /// A ray between the corners meets the plane only where one of the corners' does.
    [[nodiscard]] bool excludes(Vec3 point, Vec3 normal) const {
        return std::none_of(corners_.begin(), corners_.end(), [&](const Ray& ray) {
            const Real height = dot(normal, ray.o - point), rise = dot(normal, ray.d);
            return height == 0 || height * rise < 0;
        });
    }

  private:
    std::array<Ray, 4> corners_;
    std::array<HalfSpace, 5> sides_;
};

/// Of a picture that is four times wider than it is high at least, so that the width does not
/// matter: an output may have another one.
std::optional<View> view_of(const SceneDescription& scene) {
    const int height = scene.resolution.height;
    const renderer::Resolution wide{std::max(scene.resolution.width, 4 * height), height};
    const auto camera = renderer::Camera::create(scene.camera, wide, {});
    if (!camera) return std::nullopt;
    const auto w = static_cast<Real>(wide.width), h = static_cast<Real>(wide.height);
    return View({camera->generate({0, 0}), camera->generate({w, 0}), camera->generate({w, h}),
                 camera->generate({0, h})},
                camera->generate({w / 2, h / 2}));
}

bool is_outside(const SceneDescription& scene, const View& view, const Place& place) {
    const ObjectDescription& object = scene.objects[place.object];
    const auto* plane = std::get_if<renderer::Plane>(&object.placed.shape);
    if (plane == nullptr) return !place.bounds.empty() && view.excludes(place.bounds);
    const renderer::Transform& to_world = object.placed.instances[place.instance];
    const auto to_object = to_world.inverse();
    return to_object &&
           view.excludes(to_world.point(plane->point), to_object->transposed(plane->normal));
}

/// Whether light reaches what is inside a closed opaque place, as far as lamps tell; things that
/// shine may be inside.
bool has_light_inside(const SceneDescription& scene, const Place& place) {
    const auto is_inside = [&](const renderer::LightDescription& light) {
        const auto* point = std::get_if<renderer::PointLight>(&light);
        return point != nullptr && place.shape->contains(point->position);
    };
    const auto shines = [&](const ObjectDescription& object) {
        return scene.materials[object.material].emission.spectrum != nullptr;
    };
    return std::any_of(scene.lights.begin(), scene.lights.end(), is_inside) ||
           std::any_of(scene.objects.begin(), scene.objects.end(), shines) ||
           (scene.ambient && scene.ambient->illuminant);
}

}  // namespace

void warn_of_camera(const SceneDescription& scene, const std::vector<Place>& places,
                    WarningSink& sink) {
    const Vec3 from = std::visit([](const auto& camera) { return camera.from; }, scene.camera);
    const bool is_perspective = std::holds_alternative<renderer::PerspectiveCamera>(scene.camera);
    for (const Place& place : places) {
        const ObjectDescription& object = scene.objects[place.object];
        if (!is_perspective || !is_around(place, from)) continue;
        if (renderer::needs_of(scene.materials[object.material]).transmits) continue;
        if (has_light_inside(scene, place)) continue;
        sink.warn(
            "/camera", "camera-shut-in",
            "it stands inside \"" + object.name + "\", which is opaque, and no light is in there",
            "move the camera out, or put a lamp in");
        return;
    }
    const auto view = view_of(scene);
    if (!view || places.empty()) return;
    if (!std::all_of(places.begin(), places.end(),
                     [&](const Place& place) { return is_outside(scene, *view, place); })) {
        return;
    }
    sink.warn("/camera", "camera-sees-nothing", "no object is in its view",
              "see where it stands and where it looks");
}

}  // namespace bouguer::api
