// SPDX-License-Identifier: Apache-2.0
// Geometry on Embree: the queries. How it is put together is in geometry_builder.cpp.
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "renderer/geometry/analytic_set.h"
#include "renderer/geometry/embree_api.h"
#include "renderer/geometry/geometry.h"
#include "renderer/geometry/geometry_query.h"
#include "renderer/geometry/mesh_part.h"
#include "renderer/geometry/nested_meshes.h"
#include "renderer/geometry/surface_coordinates.h"

namespace bouguer::renderer {

/// An infinite plane: dot(n, p) = offset.
struct PlanePart {
    Vec3 n;
    Real offset = 0;
    PartOwner owner;
    Real placing = 0;  ///< what the numbers of the document leave open, scene units
};

/// What Embree has allocated, and how much it may.
struct EmbreeMemory {
    std::atomic<std::int64_t> bytes{0};
    std::uint64_t max_bytes = 0;
    std::atomic<bool> exceeded{false};
};

/// Everything that queries read. Immutable once built.
struct GeometryData {
    std::unique_ptr<EmbreeMemory> memory =
        std::make_unique<EmbreeMemory>();  ///< outlives the device, which reports to it
    DeviceHandle device;
    std::vector<SceneHandle> own_scenes;  ///< of one mesh each
    SceneHandle scene;                    ///< null when it would be empty
    /// Parts are numbered: meshes, analytic shapes, planes. Embree's geometry i is mesh i, if that
    /// is in the main scene; after the last mesh come all analytic shapes, then all nested meshes.
    std::vector<MeshPart> meshes;
    std::vector<PartOwner> mesh_owners;
    std::unique_ptr<AnalyticSet> analytic = std::make_unique<AnalyticSet>();
    std::unique_ptr<NestedMeshes> nested = std::make_unique<NestedMeshes>();
    std::vector<PlanePart> planes;
    std::vector<PlaneCoordinates> plane_coordinates;  ///< by plane; apart, as few rays need them
    std::vector<std::uint32_t> first_of_object;       ///< in part_of_instance
    std::vector<std::uint32_t> part_of_instance;
    std::vector<Bounds> mesh_bounds;  ///< by mesh
    Real mesh_reach = 0;  ///< the worst that single precision does to a mesh, scene units
    Vec3 origin;
    Real radius = 0;
    Real scale = 1;    ///< from scene units to Embree's: a power of two
    Real unscale = 1;  ///< its inverse
    std::uint32_t num_meshes = 0;
    std::uint64_t num_triangles = 0;
    std::uint64_t own_bytes = 0;
};

class EmbreeGeometry final : public Geometry {
  public:
    explicit EmbreeGeometry(GeometryData data) : data_(std::move(data)) {}

    bool nearest(const Ray& ray, Real t_max, Hit& hit) const override;
    [[nodiscard]] bool occluded(const Ray& ray, Real t_max) const override;
    void crossings(const Ray& ray, Real from, Real to, std::vector<Hit>& crossings) const override;
    [[nodiscard]] Real reach(const Hit& hit) const override;
    [[nodiscard]] bool contains(std::uint32_t object, std::uint32_t instance,
                                Vec3 p) const override;
    [[nodiscard]] bool touches(std::uint32_t object, std::uint32_t instance, Vec3 p,
                               Real reach) const override;
    [[nodiscard]] bool is_thin(std::uint32_t object, std::uint32_t instance) const override;
    [[nodiscard]] Bounds bounds(std::uint32_t object, std::uint32_t instance) const override;
    [[nodiscard]] Vec2 surface_uv(const Hit& hit) const override;
    [[nodiscard]] Vec3 smooth_point(const Hit& hit) const override;
    [[nodiscard]] Vec3 origin() const override { return data_.origin; }
    [[nodiscard]] Real radius() const override { return data_.radius; }
    [[nodiscard]] std::uint64_t num_triangles() const override { return data_.num_triangles; }
    [[nodiscard]] std::uint64_t memory_bytes() const override;

    /// What queries read; for benchmarks that ask Embree without us.
    [[nodiscard]] const GeometryData& data() const { return data_; }

  private:
    [[nodiscard]] std::size_t part_of(std::uint32_t object, std::uint32_t instance) const {
        return data_.part_of_instance[data_.first_of_object[object] + instance];
    }
    void settle_edges(Vec3 d, std::vector<Hit>& crossings) const;
    [[nodiscard]] std::size_t first_plane() const {
        return data_.meshes.size() + data_.analytic->shapes.size();
    }

    GeometryData data_;
};

/// Where along `ray` it comes near what lies within `radius` of zero, so that a distant origin
/// costs single precision nothing. Infinite when it passes by.
[[nodiscard]] Real approach(const Ray& ray, Real radius);

/// Fills all of `r` with what lies between `shift` and `t_max` of `ray`, in lengths over `scale`.
void set_ray(RTCRay& r, const Ray& ray, Real scale, Real shift, Real t_max);

/// The nearest triangle of `scene` that `record.ray` meets in front of the origin of query.ray, met
/// in double; false when there is none, or something else is nearer. Embree's lengths are
/// (t - shift) * scale. `part_of` gives the number of the mesh by Embree's number of the geometry;
/// GeometryQuery::kNoPart for what is no mesh.
template <class PartOf>
bool nearest_triangle(RTCScene scene, RTCRayHit& record, GeometryQuery& query, Real scale,
                      Real shift, PartOf part_of, Hit& hit) {
    // Triangles that turn out to lie behind the ray's origin are passed over this many times.
    constexpr int kMaxRetries = 8;
    const float tfar = record.ray.tfar;
    for (int i = 0; i < kMaxRetries; ++i) {
        record.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        record.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        embree_intersect(scene, record, query);
        if (record.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
        const std::uint32_t part = part_of(record.hit.geomID);
        if (part == GeometryQuery::kNoPart) return false;
        const TriangleHit at{record.hit.primID, static_cast<Real>(record.ray.tfar) / scale + shift,
                             record.hit.u, record.hit.v};
        query.data->meshes[part].refine(*query.ray, at, hit);
        set_owner(hit, part, query.data->mesh_owners[part]);
        if (hit.t > 0) return true;
        record.ray.tnear = std::nextafter(record.ray.tfar, std::numeric_limits<float>::infinity());
        record.ray.tfar = tfar;
    }
    return false;
}

}  // namespace bouguer::renderer
