// SPDX-License-Identifier: Apache-2.0
#include "api/scene_warnings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "api/json_value.h"
#include "renderer/geometry/analytic_shape.h"
#include "renderer/spectrum/colour.h"
#include "renderer/spectrum/refractive_index.h"

namespace bouguer::api {
namespace {

using renderer::Bounds;
using renderer::MaterialDescription;
using renderer::ObjectDescription;
using renderer::Real;
using renderer::SceneDescription;
using renderer::SurfaceSpectrum;
using renderer::Vec3;

/// Rounding of shares that are meant to be the whole.
constexpr double kSlack = 1e-6;

/// The largest value at a wavelength, of all spectra that a texture mixes; by 5 nm.
double value_at(const SurfaceSpectrum& s, double lambda_nm) {
    double most = 0;
    for (const auto& part : s.parts()) most = std::max(most, part->at(lambda_nm));
    return most;
}

template <class Function>
double largest(Function at) {
    double most = 0;
    for (double nm = renderer::kLambdaMin_nm; nm <= renderer::kLambdaMax_nm; nm += 5)
        most = std::max(most, at(nm));
    return most;
}

// ---- the most that a surface gives back of light of one wavelength ----

/// The lobe (L.N)^n holds 2 / (n + 1) of a matt surface's light: more than the whole for n < 1.
double most_given(const renderer::HallMaterial& m) {
    const double lobe = m.mirror ? 1 : std::max(1.0, 2 / (m.n + 1));
    return largest([&](double nm) {
        return m.k_sr * lobe * value_at(m.reflectance, nm) + m.k_st * value_at(m.transmittance, nm);
    });
}

template <class Glossy>
double most_of_matt_and_gloss(const Glossy& m) {
    return largest([&](double nm) {
        return m.k_d * value_at(m.diffuse, nm) + m.k_s * value_at(m.specular, nm);
    });
}
double most_given(const renderer::PhongMaterial& m) { return most_of_matt_and_gloss(m); }
double most_given(const renderer::BlinnMaterial& m) { return most_of_matt_and_gloss(m); }
double most_given(const renderer::CookTorranceMaterial& m) { return most_of_matt_and_gloss(m); }

/// Fresnel's reflectance divides what is mirrored and what goes through.
double most_given(const renderer::HallGreenbergMaterial& m) {
    return largest([&](double nm) {
        return m.k_dr * value_at(m.diffuse, nm) +
               std::max(m.k_sr * value_at(m.specular, nm), m.k_st * value_at(m.transmittance, nm));
    });
}

/// What is inside a body.
struct Inside {
    renderer::SpectrumPtr ior;
    std::optional<renderer::Absorption> absorption;
};

Inside inside_of(const renderer::HallMaterial& m) { return {m.ior, m.absorption}; }
Inside inside_of(const renderer::HallGreenbergMaterial& m) { return {m.index.n, m.absorption}; }
template <class Opaque>
Inside inside_of(const Opaque& /*m*/) {
    return {};
}

bool transmits(const MaterialDescription& material) { return needs_of(material).transmits; }

bool bends(const Inside& inside) {
    return inside.ior && (!inside.ior->is_constant() || inside.ior->at(renderer::kLineD_nm) != 1);
}

/// A shape with a closed form where it stands; empty for planes and meshes.
std::optional<renderer::AnalyticShape> analytic(const ObjectDescription& object,
                                                std::size_t instance) {
    return renderer::AnalyticShape::create(object.placed.shape, object.placed.instances[instance]);
}

/// World coordinates; empty for planes.
Bounds bounds_of(const ObjectDescription& object, std::size_t instance) {
    if (const auto shape = analytic(object, instance)) return shape->bounds();
    Bounds bounds;
    if (const auto* mesh =
            std::get_if<std::shared_ptr<const renderer::TriangleMesh>>(&object.placed.shape)) {
        for (const Vec3& p : (*mesh)->positions)
            bounds.add(object.placed.instances[instance].point(p));
    }
    return bounds;
}

/// Whether a box lies inside a convex shape.
bool contains(const renderer::AnalyticShape& shape, const Bounds& box) {
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p{(corner & 1) != 0 ? box.hi.x : box.lo.x,
                     (corner & 2) != 0 ? box.hi.y : box.lo.y,
                     (corner & 4) != 0 ? box.hi.z : box.lo.z};
        if (!shape.contains(p)) return false;
    }
    return true;
}

using MeshPtr = std::shared_ptr<const renderer::TriangleMesh>;

/// Warns of one scene.
class SceneCheck {
  public:
    SceneCheck(const SceneDescription& scene, const std::string& pointer, Problems& problems)
        : scene_(scene), pointer_(pointer), problems_(problems) {}

    void materials() {
        std::set<std::size_t> used;
        for (const ObjectDescription& object : scene_.objects) used.insert(object.material);
        for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
            const MaterialDescription& material = scene_.materials[i];
            const std::string at = pointer_ + "/materials/" + pointer_token(material.name);
            if (!used.contains(i)) {
                problems_.warn({at, "unused-material", "no object has this material",
                                "remove it, or give it to an object"});
            }
            const double most =
                std::visit([](const auto& m) { return most_given(m); }, material.model);
            if (most > 1 + kSlack) {
                problems_.warn({at, "gains-energy",
                                "at some wavelength this surface gives back " + number_text(most) +
                                    " times the light that it gets",
                                "let its shares times its spectra be at most 1 in sum"});
            }
        }
    }

    void objects() {
        for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
            const ObjectDescription& object = scene_.objects[i];
            const MaterialDescription& material = scene_.materials[object.material];
            if (const auto* mesh = std::get_if<MeshPtr>(&object.placed.shape)) {
                warn_of_mesh(i, **mesh);
            }
            if (!transmits(material)) {
                if (object.priority != 0) {
                    problems_.warn({at(i), "priority-without-effect",
                                    "what is opaque is always met, whatever its priority",
                                    "leave the priority out"});
                }
                continue;
            }
            const Inside inside =
                std::visit([](const auto& m) { return inside_of(m); }, material.model);
            if (std::holds_alternative<renderer::Disk>(object.placed.shape)) {
                warn_of_sheet(i, inside);
                continue;
            }
            if (inside.absorption) warn_of_absorption(i, object, *inside.absorption);
            warn_if_hidden(i, object);
        }
    }

    void ambient() {
        if (!scene_.ambient) return;
        const auto* given = std::get_if<renderer::ExplicitWeights>(&scene_.ambient->weights);
        if (given == nullptr) return;
        Real sum = 0;
        for (const Real k : given->k) sum += k;
        if (!(sum > 1 + kSlack)) return;
        problems_.warn({pointer_ + "/ambient/weights", "ambient-above-one",
                        "the weights of the neighbours are " + number_text(sum) + " in sum",
                        "let them be shares of the hemisphere: at most 1 in sum"});
    }

  private:
    [[nodiscard]] std::string at(std::size_t object) const {
        return pointer_ + "/objects/" + std::to_string(object);
    }

    void warn(std::size_t i, const char* code, const std::string& detail, const char* advice) {
        problems_.warn({at(i) + "/shape", code, detail, advice});
    }

    /// Once, however many objects have the mesh.
    void warn_of_mesh(std::size_t i, const renderer::TriangleMesh& mesh) {
        if (!meshes_.insert(&mesh).second) return;
        warn_of_file(i, mesh.notes);
        if (mesh.topology) warn_of_topology(i, *mesh.topology);
    }

    void warn_of_file(std::size_t i, const renderer::MeshNotes& notes) {
        if (!notes.materials.empty()) {
            warn(i, "mesh-materials-dropped",
                 "the materials that the file names are not read: " + notes.materials.text(),
                 "give each part an object and a material of its own");
        }
        if (!notes.dropped.empty()) {
            warn(i, "mesh-parts-dropped", "the file has more than is read: " + notes.dropped.text(),
                 "see that the surface does not need them");
        }
        if (notes.crossed_polygons > 0) {
            warn(i, "mesh-crossed-polygons",
                 std::to_string(notes.crossed_polygons) + " polygons have borders that cross",
                 "cut them into triangles before");
        }
    }

    void warn_of_topology(std::size_t i, const renderer::MeshTopology& topology) {
        if (topology.doubled_triangles > 0) {
            warn(i, "mesh-doubled",
                 std::to_string(topology.doubled_triangles) +
                     " triangles lie in the place of others and are left out",
                 "remove them from the mesh");
        }
        if (!topology.is_closed) {
            warn(i, "mesh-open",
                 "light goes through this mesh, which has no inside: " +
                     (topology.open_edges > 0 ? std::to_string(topology.open_edges) + " open edges"
                                              : std::string("its surface has one side only")),
                 "close it; where it is meant as a sheet, use a material without index and "
                 "absorption");
        }
        if (topology.flipped_triangles > 0) {
            warn(i, "mesh-inside-out",
                 std::to_string(topology.flipped_triangles) +
                     " triangles wind the wrong way and are turned round",
                 "let triangles wind counter-clockwise as seen from outside");
        }
    }

    void warn_of_sheet(std::size_t i, const Inside& inside) {
        if (!bends(inside) && !inside.absorption) return;
        problems_.warn({at(i), "sheet-without-inside",
                        "a disk has no inside: the index of refraction and the absorption of its "
                        "material count for nothing",
                        "use a cylinder for a plate, or a material without them"});
    }

    /// Nothing comes through where the optical depth of the body's own size is above this at every
    /// wavelength: less than 1e-13.
    void warn_of_absorption(std::size_t i, const ObjectDescription& object,
                            const renderer::Absorption& absorption) {
        constexpr Real kNothing = 30;
        const Bounds bounds = bounds_of(object, 0);
        if (bounds.empty()) return;
        const Vec3 size = bounds.hi - bounds.lo;
        const Real least = std::min({size.x, size.y, size.z});
        const double most = largest([&](double nm) { return absorption.transmittance->at(nm); });
        const Real depth = -std::log(most) * least / absorption.thickness;
        if (!(depth > kNothing)) return;
        problems_.warn({at(i), "absorbs-everything",
                        "through its thinnest extent, " + number_text(least) +
                            " scene units, the optical depth is at least " + number_text(depth),
                        "see that the thickness of the absorption is in the scene's units"});
    }

    void warn_if_hidden(std::size_t i, const ObjectDescription& object) {
        const Bounds bounds = bounds_of(object, 0);
        if (bounds.empty() || object.placed.instances.size() > 1) return;
        for (std::size_t j = 0; j < i; ++j) {
            const ObjectDescription& other = scene_.objects[j];
            if (other.priority < object.priority || other.placed.instances.size() > 1) continue;
            if (!transmits(scene_.materials[other.material])) continue;
            const auto shape = analytic(other, 0);
            if (!shape || !contains(*shape, bounds)) continue;
            problems_.warn(
                {at(i), "body-hidden",
                 "it lies wholly inside \"" + other.name + "\", which counts more where both are",
                 "give it a higher priority"});
            return;
        }
    }

    const SceneDescription& scene_;
    const std::string& pointer_;
    Problems& problems_;
    std::set<const renderer::TriangleMesh*> meshes_;  ///< that were looked at
};

/// Where the camera looks.
Vec3 target(const SceneDescription& scene) {
    return std::visit([](const auto& camera) { return camera.at; }, scene.camera);
}

/// What lamps and environment give to a white surface there that faces them, in Y; 0 without lamps.
double white_luminance(const SceneDescription& scene) {
    double sum = 0;
    for (const renderer::LightDescription& light : scene.lights) {
        if (const auto* point = std::get_if<renderer::PointLight>(&light)) {
            const Real metres = length(point->position - target(scene)) * scene.metres_per_unit;
            if (metres > 0) sum += renderer::xyz_of(*point->intensity).y / (metres * metres);
        } else {
            sum += renderer::xyz_of(*std::get<renderer::DirectionalLight>(light).irradiance).y;
        }
    }
    return sum;
}

bool shines(const SceneDescription& scene) {
    return scene.environment ||
           std::any_of(scene.materials.begin(), scene.materials.end(),
                       [](const MaterialDescription& m) { return m.emission.spectrum != nullptr; });
}

}  // namespace

void warn_of_scene(const SceneDescription& scene, const std::string& pointer, Problems& problems) {
    SceneCheck check(scene, pointer, problems);
    check.materials();
    check.objects();
    check.ambient();
}

void warn_of_exposure(const SceneDescription& scene, const renderer::OutputSettings& output,
                      const std::string& pointer, Problems& problems) {
    constexpr double kStops = 10;
    if (!output.exposure || scene.lights.empty() || shines(scene)) return;
    const double stops = std::log2(white_luminance(scene) * *output.exposure);
    if (!(std::abs(stops) > kStops)) return;
    problems.warn({pointer + "/lights", stops > 0 ? "lamps-too-bright" : "lamps-too-dark",
                   "a white surface where the camera looks is " +
                       number_text(std::round(std::abs(stops))) + " stops " +
                       (stops > 0 ? "brighter" : "darker") + " than white at this exposure",
                   "see that lengths and lamps are in the scene's units, or leave the exposure to "
                   "the renderer"});
}

}  // namespace bouguer::api
