// SPDX-License-Identifier: Apache-2.0
// From placed shapes to Embree scenes.
#include <cmath>
#include <map>
#include <new>
#include <string>
#include <utility>
#include <variant>

#include "renderer/core/out_of_memory.h"
#include "renderer/core/thread_sanitizer.h"
#include "renderer/geometry/embree_geometry.h"

namespace bouguer::renderer {
namespace {

using MeshPtr = std::shared_ptr<const TriangleMesh>;

struct PlacedMesh {
    MeshPtr mesh;
    Transform to_world;
    PartOwner owner;
    Bounds bounds;  ///< world coordinates
};

/// A mesh in the main scene suffers the rounding of the scene's size: at most so many times what
/// its own size costs it.
constexpr Real kMostRounding = 16;

/// The power of two that brings `size` into [1, 2); 1 when there is no size.
Real unit_scale(Real size) {
    return size > 0 && std::isfinite(size) ? std::ldexp(1.0, -std::ilogb(size)) : 1;
}

Transform scaled(const Transform& m, Real by) {
    return {{by * m.a[0], by * m.a[1], by * m.a[2]}, by * m.t};
}

/// Of the vertices that triangles use.
Bounds bounds_of(const TriangleMesh& mesh, const Transform& transform) {
    Bounds bounds;
    for (const auto& corners : mesh.triangles) {
        for (const std::uint32_t i : corners) bounds.add(transform.point(mesh.positions[i]));
    }
    return bounds;
}

/// What is wrong with a mesh that Embree would not survive; empty when nothing is.
std::string fault_of(const MeshPtr& mesh) {
    if (!mesh || mesh->triangles.empty()) return "has no triangles";
    const std::size_t n = mesh->positions.size();
    for (const auto& corners : mesh->triangles) {
        if (corners[0] >= n || corners[1] >= n || corners[2] >= n) {
            return "has a vertex index out of range";
        }
    }
    if (!mesh->normals.empty() && mesh->normals.size() != n) return "lacks normals";
    if (!mesh->uvs.empty() && mesh->uvs.size() != n) return "lacks texture coordinates";
    return {};
}

/// Called by Embree before it allocates and after it frees, from any thread.
bool count_memory(void* user, ssize_t bytes, bool post) {
    auto& memory = *static_cast<EmbreeMemory*>(user);
    const std::int64_t total = memory.bytes.fetch_add(bytes) + bytes;
    if (post || bytes <= 0 || total <= 0) return true;
    if (static_cast<std::uint64_t>(total) <= memory.max_bytes) return true;
    memory.exceeded = true;
    return false;
}

class Builder {
  public:
    explicit Builder(const GeometryOptions& options) : options_(options) {}

    Result<std::unique_ptr<const Geometry>> build(std::span<const PlacedShape> shapes) {
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            if (auto sorted = sort(shapes[i], static_cast<std::uint32_t>(i)); !sorted) {
                return tl::unexpected<Error>(std::move(sorted.error()));
            }
        }
        centre();
        number_parts(shapes);
        if (!meshes_.empty() || !data_.analytic->shapes.empty()) {
            if (auto uploaded = upload(); !uploaded) {
                return tl::unexpected<Error>(std::move(uploaded.error()));
            }
        }
        return std::make_unique<const EmbreeGeometry>(std::move(data_));
    }

  private:
    /// Sorts a shape's instances into meshes, analytic shapes and planes, in world coordinates.
    Result<void> sort(const PlacedShape& placed, std::uint32_t object) {
        const auto* mesh = std::get_if<MeshPtr>(&placed.shape);
        if (mesh != nullptr) {
            if (const std::string fault = fault_of(*mesh); !fault.empty()) {
                return refuse(object, fault);
            }
        }
        for (std::size_t i = 0; i < placed.instances.size(); ++i) {
            const Transform& instance = placed.instances[i];
            const PartOwner owner{object, static_cast<std::uint32_t>(i)};
            const auto inverse = instance.inverse();
            if (!inverse) return refuse(object, "has a transform that cannot be inverted");
            if (mesh != nullptr) {
                const Bounds bounds = bounds_of(**mesh, instance);
                if (!is_finite(bounds.half_size())) return refuse(object, "is not finite");
                bounds_.add(bounds);
                meshes_.push_back({*mesh, instance, owner, bounds});
            } else if (const auto* plane = std::get_if<Plane>(&placed.shape)) {
                const Vec3 n = normalize(inverse->transposed(plane->normal));
                const Vec3 point = instance.point(plane->point);
                if (!is_finite(n) || !is_finite(point)) return refuse(object, "is not finite");
                data_.planes.push_back(
                    {n, dot(n, point), owner, instance.rounding(max_abs(plane->point))});
                data_.plane_coordinates.emplace_back(plane->normal, *inverse);
                plane_points_.push_back(point);
            } else {
                const auto shape = AnalyticShape::create(placed.shape, instance);
                if (!shape || !is_finite(shape->bounds().half_size())) {
                    return refuse(object, "has no size or is not finite");
                }
                bounds_.add(shape->bounds());
                data_.analytic->shapes.push_back(*shape);
                data_.analytic->owners.push_back(owner);
            }
        }
        return {};
    }

    static tl::unexpected<Error> refuse(std::uint32_t object, const std::string& why) {
        return fail(ErrorKind::InvalidInput, "object " + std::to_string(object) + " " + why,
                    "bad-geometry");
    }

    /// Moves everything so that the middle of the bounds is the origin of coordinates.
    void centre() {
        if (!bounds_.empty()) {
            data_.origin = bounds_.middle();
            data_.radius = length(bounds_.half_size());
        }
        data_.scale = unit_scale(data_.radius);
        data_.unscale = 1 / data_.scale;
        data_.num_meshes = static_cast<std::uint32_t>(meshes_.size());
        for (AnalyticShape& shape : data_.analytic->shapes) shape = shape.relative_to(data_.origin);
        for (std::size_t i = 0; i < data_.planes.size(); ++i) {
            data_.planes[i].offset = dot(data_.planes[i].n, plane_points_[i] - data_.origin);
            data_.plane_coordinates[i] = data_.plane_coordinates[i].relative_to(data_.origin);
        }
    }

    /// Which part is which instance of which object.
    void number_parts(std::span<const PlacedShape> shapes) {
        std::uint32_t instances = 0;
        for (const PlacedShape& shape : shapes) {
            data_.first_of_object.push_back(instances);
            instances += static_cast<std::uint32_t>(shape.instances.size());
        }
        data_.part_of_instance.resize(instances);
        std::uint32_t part = 0;
        const auto number = [&](PartOwner owner) {
            data_.part_of_instance[data_.first_of_object[owner.object] + owner.instance] = part++;
        };
        for (const PlacedMesh& placed : meshes_) {
            number(placed.owner);
            data_.mesh_bounds.push_back(
                {placed.bounds.lo - data_.origin, placed.bounds.hi - data_.origin});
        }
        data_.analytic->first_part = part;
        for (const PartOwner& owner : data_.analytic->owners) number(owner);
        for (const PlanePart& plane : data_.planes) number(plane.owner);
    }

    Result<void> upload() {
        data_.memory->max_bytes = options_.max_memory_bytes;
        data_.device.reset(rtcNewDevice(nullptr));
        if (!data_.device) return embree_error(rtcGetDeviceError(nullptr));
        rtcSetDeviceMemoryMonitorFunction(data_.device.get(), count_memory, data_.memory.get());
        data_.scene = new_scene();
        add_meshes();
        if (!data_.analytic->shapes.empty()) add_analytic();
        if (!data_.nested->meshes.empty()) add_nested_geometry();
        commit(data_.scene);
        if (data_.memory->exceeded || data_.own_bytes > options_.max_memory_bytes) {
            return fail(ErrorKind::TooLarge, "the scene's geometry needs more memory than allowed",
                        "geometry-memory");
        }
        if (error_ != RTC_ERROR_NONE) return embree_error(error_);
        return {};
    }

    static tl::unexpected<Error> embree_error(RTCError error) {
        return fail(ErrorKind::Internal,
                    error == RTC_ERROR_OUT_OF_MEMORY
                        ? "out of memory while building the geometry"
                        : "Embree refused the geometry, error " + std::to_string(error),
                    "embree");
    }

    SceneHandle new_scene() {
        SceneHandle scene(rtcNewScene(data_.device.get()));
        rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_MEDIUM);
        note_error();
        return scene;
    }

    void commit(const SceneHandle& scene) {
        rtcCommitScene(scene.get());
        happens_after(data_.analytic.get());  // whose bounds Embree's threads have asked for
        happens_after(data_.nested.get());
        note_error();
    }

    void note_error() {
        const RTCError error = rtcGetDeviceError(data_.device.get());
        if (error_ == RTC_ERROR_NONE) error_ = error;
    }

    void add_meshes() {
        std::map<const TriangleMesh*, std::uint64_t> copies;
        for (const PlacedMesh& placed : meshes_) {
            const std::uint64_t triangles = placed.mesh->triangles.size();
            copies[placed.mesh.get()] += triangles;
            data_.num_triangles += triangles;
        }
        for (const PlacedMesh& placed : meshes_) {
            const std::uint64_t copied = copies[placed.mesh.get()];
            const bool once = copied == placed.mesh->triangles.size();
            if ((once || copied <= options_.max_baked_triangles) && !is_small(placed)) {
                add_baked(placed);
            } else {
                add_nested(placed);
            }
            data_.mesh_owners.push_back(placed.owner);
            const Bounds& bounds = data_.mesh_bounds[data_.mesh_owners.size() - 1];
            const Real reach = max_abs(max(max(bounds.hi, -bounds.lo), -bounds.hi));
            data_.mesh_reach = std::max(data_.mesh_reach, data_.meshes.back().worst_error(reach));
        }
    }

    /// Whether single precision of the scene's size would spoil the mesh.
    [[nodiscard]] bool is_small(const PlacedMesh& placed) const {
        return data_.radius > kMostRounding * length(placed.bounds.half_size());
    }

    /// A copy of the mesh in the main scene.
    void add_baked(const PlacedMesh& placed) {
        Transform to_scene = placed.to_world;
        to_scene.t = to_scene.t - data_.origin;
        const auto buffer = keep(*placed.mesh, to_scene, data_.unscale);
        attach(data_.scene, triangles(*placed.mesh, *buffer), data_.meshes.size());
        data_.meshes.emplace_back(placed.mesh, buffer, to_scene, data_.origin);
    }

    /// A reference to a scene that holds the mesh once, about its own middle and of unit size.
    void add_nested(const PlacedMesh& placed) {
        const auto [it, is_new] = shared_.try_emplace(placed.mesh.get());
        Shared& shared = it->second;
        if (is_new) {
            const Bounds bounds = bounds_of(*placed.mesh, {});
            shared.middle = bounds.middle();
            shared.scale = unit_scale(max_abs(bounds.half_size()));
            shared.buffer =
                keep(*placed.mesh, scaled(Transform::translate(-shared.middle), shared.scale), 1);
            data_.own_scenes.push_back(new_scene());
            shared.scene = data_.own_scenes.back().get();
            attach(data_.own_scenes.back(), triangles(*placed.mesh, *shared.buffer), 0);
            commit(data_.own_scenes.back());
        }
        Transform to_scene = placed.to_world;
        to_scene.t = to_scene.t - data_.origin;
        Transform from_buffer = scaled(to_scene, 1 / shared.scale);
        from_buffer.t = to_scene.point(shared.middle);
        const auto part = static_cast<std::uint32_t>(data_.meshes.size());
        data_.nested->meshes.push_back({part, shared.scene});
        data_.nested->bounds.push_back(data_.mesh_bounds[part]);
        data_.meshes.emplace_back(placed.mesh, shared.buffer, to_scene, data_.origin, from_buffer);
    }

    GeometryHandle triangles(const TriangleMesh& mesh, const MeshBuffer& buffer) {
        GeometryHandle geometry(rtcNewGeometry(data_.device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
        rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   buffer.xyz.data(), 0, 3 * sizeof(float), mesh.positions.size());
        rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   mesh.triangles.data(), 0, 3 * sizeof(std::uint32_t),
                                   mesh.triangles.size());
        set_triangle_filter(geometry.get());
        return geometry;
    }

    void add_analytic() {
        AnalyticSet& set = *data_.analytic;
        set.scale = data_.scale;
        set.margin = box_margin();
        attach(data_.scene, make_analytic_geometry(data_.device.get(), set), data_.meshes.size());
    }

    void add_nested_geometry() {
        NestedMeshes& set = *data_.nested;
        set.scale = data_.scale;
        set.margin = box_margin();
        attach(data_.scene, make_nested_geometry(data_.device.get(), set), data_.meshes.size() + 1);
    }

    /// Rays are rounded to single precision before they meet boxes: wide enough for that.
    [[nodiscard]] Real box_margin() const { return 0x1p-20 * data_.radius; }

    void attach(const SceneHandle& scene, GeometryHandle geometry, std::size_t id) {
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometryByID(scene.get(), geometry.get(), static_cast<unsigned>(id));
        note_error();
    }

    std::shared_ptr<const MeshBuffer> keep(const TriangleMesh& mesh, const Transform& transform,
                                           Real scale) {
        auto buffer = std::make_shared<const MeshBuffer>(mesh, transform, scale);
        data_.own_bytes += buffer->bytes();
        return buffer;
    }

    struct Shared {
        Vec3 middle;
        Real scale = 1;
        std::shared_ptr<const MeshBuffer> buffer;
        RTCScene scene = nullptr;
    };

    GeometryOptions options_;
    GeometryData data_;
    Bounds bounds_;
    std::vector<PlacedMesh> meshes_;
    std::vector<Vec3> plane_points_;
    std::map<const TriangleMesh*, Shared> shared_;
    RTCError error_ = RTC_ERROR_NONE;
};

}  // namespace

Result<std::unique_ptr<const Geometry>> Geometry::build(std::span<const PlacedShape> shapes,
                                                        const GeometryOptions& options) {
    try {
        return Builder(options).build(shapes);
    } catch (const std::bad_alloc&) {
        return out_of_memory();
    }
}

}  // namespace bouguer::renderer
