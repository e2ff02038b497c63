// SPDX-License-Identifier: Apache-2.0
#include "api/body_warnings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <variant>

#include "api/json_value.h"
#include "renderer/spectrum/colour.h"

namespace bouguer::api {
namespace {

using renderer::Absorption;
using renderer::MaterialDescription;
using renderer::ObjectDescription;
using renderer::Real;
using renderer::SceneDescription;
using renderer::Vec3;

std::optional<Absorption> absorption_of(const renderer::HallMaterial& m) { return m.absorption; }
std::optional<Absorption> absorption_of(const renderer::HallGreenbergMaterial& m) {
    return m.absorption;
}
template <class Opaque>
std::optional<Absorption> absorption_of(const Opaque& /*m*/) {
    return {};
}

/// The numbers of a shape, so that equal shapes have equal ones.
std::vector<Real> numbers_of(const renderer::Shape& shape) {
    const auto add = [](std::vector<Real>& to, Vec3 v) { to.insert(to.end(), {v.x, v.y, v.z}); };
    std::vector<Real> all{static_cast<Real>(shape.index())};
    if (const auto* sphere = std::get_if<renderer::Sphere>(&shape)) {
        add(all, sphere->center);
        all.push_back(sphere->radius);
    } else if (const auto* plane = std::get_if<renderer::Plane>(&shape)) {
        add(all, plane->point);
        add(all, plane->normal);
    } else if (const auto* disk = std::get_if<renderer::Disk>(&shape)) {
        add(all, disk->center);
        add(all, disk->normal);
        all.push_back(disk->radius);
    } else if (const auto* box = std::get_if<renderer::Box>(&shape)) {
        add(all, box->min);
        add(all, box->max);
    } else if (const auto* cylinder = std::get_if<renderer::Cylinder>(&shape)) {
        add(all, cylinder->from);
        add(all, cylinder->to);
        all.push_back(cylinder->radius);
    }
    return all;
}

/// Warns of the bodies of one scene.
class BodyCheck {
  public:
    BodyCheck(const SceneDescription& scene, const std::vector<Place>& places, WarningSink& sink)
        : scene_(scene), places_(places), sink_(sink), twin_(scene.objects.size(), false) {
        for (const ObjectDescription& object : scene.objects) {
            transmits_.push_back(needs_of(scene.materials[object.material]).transmits);
            sheet_.push_back(is_sheet(scene, object));
        }
    }

    void insides() {
        for (const Place& place : places_) {
            if (place.instance > 0) continue;
            const ObjectDescription& object = scene_.objects[place.object];
            if (!transmits(place.object)) {
                if (object.priority != 0)
                    warn_of_priority(place.object,
                                     "what is opaque is always met, whatever its priority");
                continue;
            }
            const auto absorption = std::visit([](const auto& m) { return absorption_of(m); },
                                               material_of(place.object).model);
            if (sheet_[place.object]) {
                warn_of_sheet(place.object);
            } else if (absorption) {
                warn_of_absorption(place, *absorption);
            }
        }
    }

    /// What stands where something else stands.
    void twins() {
        // Meshes are told by where they lie in memory: one file is one mesh.
        using Key = std::pair<const void*, std::vector<Real>>;
        std::map<Key, std::size_t> first;
        std::vector<Real> shape;
        for (const Place& place : places_) {
            const ObjectDescription& object = scene_.objects[place.object];
            if (place.instance == 0) shape = numbers_of(object.placed.shape);
            Key key{mesh_of(object), shape};
            const renderer::Transform& at = object.placed.instances[place.instance];
            for (const Vec3& v : {at.a[0], at.a[1], at.a[2], at.t})
                key.second.insert(key.second.end(), {v.x, v.y, v.z});
            const auto [other, is_new] = first.try_emplace(std::move(key), place.object);
            if (!is_new) warn_of_twin(place, other->second);
        }
    }

    /// Not done where there is too much to compare.
    void hidden() {
        constexpr std::size_t kMostPairs = 20'000'000;
        std::vector<const Place*> hulls;
        for (const Place& place : places_)
            if (place.shape) hulls.push_back(&place);
        if (hulls.size() * places_.size() > kMostPairs) return;
        const Place* hider = nullptr;  // of the object's instances so far; null: one may be seen
        for (std::size_t i = 0; i < places_.size(); ++i) {
            const Place& place = places_[i];
            if (place.instance == 0 || hider != nullptr) hider = hider_of(place, hulls);
            const bool is_last = place.instance + 1 == instances_of(place.object);
            if (is_last && hider != nullptr && !twin_[place.object])
                warn_of_hidden(place.object, hider->object);
        }
    }

  private:
    [[nodiscard]] const MaterialDescription& material_of(std::size_t object) const {
        return scene_.materials[scene_.objects[object].material];
    }
    [[nodiscard]] bool transmits(std::size_t object) const { return transmits_[object]; }
    [[nodiscard]] std::size_t instances_of(std::size_t object) const {
        return scene_.objects[object].placed.instances.size();
    }
    [[nodiscard]] std::string name_of(std::size_t object) const {
        return "\"" + scene_.objects[object].name + "\"";
    }

    void warn_of_priority(std::size_t object, const char* why) {
        sink_.warn(WarningSink::object(object), "priority-without-effect", why,
                   "leave the priority out");
    }

    void warn_of_sheet(std::size_t object) {
        if (scene_.objects[object].priority != 0)
            warn_of_priority(object, "it has no inside where bodies could overlap");
        if (!renderer::has_inside(needs_of(material_of(object)))) return;
        sink_.warn(WarningSink::object(object), "sheet-without-inside",
                   "a disk has no inside: the index of refraction and the absorption of its "
                   "material count for nothing",
                   "use a cylinder for a plate, or a material without them");
    }

    /// Nothing comes through where the optical depth at every wavelength is above kNothing (less
    /// than 1e-13), and nothing is absorbed where it is nowhere above kUnseen.
    void warn_of_absorption(const Place& place, const Absorption& absorption) {
        constexpr Real kNothing = 30, kUnseen = 1e-6;
        double least = 1, most = 0;
        for (double nm = renderer::kLambdaMin_nm; nm <= renderer::kLambdaMax_nm; nm += 5) {
            least = std::min(least, absorption.transmittance->at(nm));
            most = std::max(most, absorption.transmittance->at(nm));
        }
        const Real thin = thickness_of(place);
        if (const Real depth = -std::log(most) * thin / absorption.thickness; depth > kNothing) {
            sink_.warn(WarningSink::object(place.object), "absorbs-everything",
                       "already after " + number_text(thin) +
                           " scene units, and it is no thinner, the optical depth is " +
                           number_text(depth),
                       "see that the thickness of the absorption is in the scene's units");
        }
        if (place.bounds.empty() || !(least < 1)) return;
        const Real thick = length(place.bounds.hi - place.bounds.lo);
        if (const Real depth = -std::log(least) * thick / absorption.thickness; depth < kUnseen) {
            sink_.warn(WarningSink::object(place.object), "absorbs-nothing",
                       "through " + number_text(thick) +
                           " scene units, and it is no thicker, the optical depth is " +
                           number_text(depth),
                       "see that the thickness of the absorption is in the scene's units");
        }
    }

    /// A length, scene units, that the body is not thinner than: half the shortest axis of a convex
    /// one, the wall of a closed mesh. 0 where it cannot be told.
    [[nodiscard]] Real thickness_of(const Place& place) {
        if (place.shape) return place.shape->thinnest();
        const ObjectDescription& object = scene_.objects[place.object];
        const renderer::TriangleMesh* mesh = mesh_of(object);
        if (mesh == nullptr || !mesh->topology || !mesh->topology->is_closed) return 0;
        const auto [wall, is_new] = walls_.try_emplace(mesh, 0);
        if (is_new) wall->second = wall_of(*mesh);
        const Real volume = object.placed.instances[place.instance].determinant();
        return std::cbrt(std::abs(volume)) * wall->second;
    }

    void warn_of_twin(const Place& place, std::size_t other) {
        twin_[place.object] = true;
        const std::string at = WarningSink::object(place.object);
        const bool is_one_of_many = instances_of(place.object) > 1;
        sink_.warn(is_one_of_many ? at + "/instances/" + std::to_string(place.instance) : at,
                   "same-place", "it stands in the very place of " + name_of(other),
                   "remove one of them: only one is seen there");
    }

    /// A convex place that nobody can see this one through; null when there is none.
    [[nodiscard]] const Place* hider_of(const Place& place,
                                        const std::vector<const Place*>& hulls) const {
        const auto hides = [&](const Place* hull) {
            return hull->object != place.object && is_hiding(*hull, place) &&
                   is_around(*hull, scene_.objects[place.object], place);
        };
        const auto found = std::find_if(hulls.begin(), hulls.end(), hides);
        return found != hulls.end() ? *found : nullptr;
    }

    /// Whether what is inside `hull` cannot be seen if it is `place`.
    [[nodiscard]] bool is_hiding(const Place& hull, const Place& place) const {
        if (!transmits(hull.object)) return !is_around_camera(hull);
        if (!transmits(place.object) || sheet_[place.object]) return false;
        const int own = scene_.objects[place.object].priority;
        const int other = scene_.objects[hull.object].priority;
        return other > own || (other == own && hull.object < place.object);
    }

    /// Whether rays may begin inside: those of an orthographic camera begin all over its film.
    [[nodiscard]] bool is_around_camera(const Place& hull) const {
        if (const auto* camera = std::get_if<renderer::PerspectiveCamera>(&scene_.camera))
            return hull.shape->contains(camera->from);
        const auto& camera = std::get<renderer::OrthographicCamera>(scene_.camera);
        const Vec3 nearest = hull.bounds.middle() - camera.from;
        const Vec3 forward = normalize(camera.at - camera.from);
        return dot(nearest, forward) < length(hull.bounds.half_size());
    }

    void warn_of_hidden(std::size_t object, std::size_t hider) {
        const std::string where = "it lies wholly inside " + name_of(hider);
        if (transmits(hider)) {
            sink_.warn(WarningSink::object(object), "body-hidden",
                       where + ", which counts more where both are", "give it a higher priority");
        } else {
            sink_.warn(WarningSink::object(object), "body-hidden", where + ", which is opaque",
                       "move it, or let light go through what is around it");
        }
    }

    const SceneDescription& scene_;
    const std::vector<Place>& places_;
    WarningSink& sink_;
    std::map<const renderer::TriangleMesh*, Real> walls_;
    std::vector<bool> transmits_, sheet_;  ///< by object
    std::vector<bool> twin_;  ///< by object: it has been said that another stands in its place
};

}  // namespace

void warn_of_bodies(const SceneDescription& scene, const std::vector<Place>& places,
                    WarningSink& sink) {
    BodyCheck check(scene, places, sink);
    check.insides();
    check.twins();
    check.hidden();
}

}  // namespace bouguer::api
