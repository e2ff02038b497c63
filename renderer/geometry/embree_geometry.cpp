// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/embree_geometry.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

namespace bouguer::renderer {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
/// Triangles that turn out to lie behind the ray's origin are passed over this many times.
constexpr int kMaxRetries = 8;

bool is_finite(const Ray& ray) {
    const Real sum = ray.o.x + ray.o.y + ray.o.z + ray.d.x + ray.d.y + ray.d.z;
    return sum - sum == 0;
}

Real distance_to(const PlanePart& plane, const Ray& ray) {
    const Real t = (plane.offset - dot(plane.n, ray.o)) / dot(plane.n, ray.d);
    return t > 0 ? t : kInfinity;
}

void complete(const PlanePart& plane, const Ray& ray, Real t, Hit& hit) {
    const Vec3 p = ray.at(t);
    hit.t = t;
    hit.p = p + (plane.offset - dot(plane.n, p)) * plane.n;
    hit.ng = hit.ns = plane.n;
    hit.error = 0x1p-41 * (max_abs(hit.p) + std::abs(plane.offset));
    hit.primitive = 0;
}

/// Where along `ray` it comes near the scene, so that a distant origin costs single precision
/// nothing. Infinite when it passes by.
Real approach(const Ray& ray, Real radius) {
    if (max_abs(ray.o) <= 8 * radius) return 0;
    const Real along = -dot(ray.o, ray.d);
    if (along <= 0) return kInfinity;
    if (max_abs(ray.at(along)) > 2 * radius) return kInfinity;
    return along - 4 * radius;
}

/// Four floats that are stored at once: Embree loads them so, and would wait for single stores.
using Float4 = float __attribute__((vector_size(16)));

/// Fills all of `r`.
void set_ray(RTCRay& r, const Ray& ray, Real scale, Real shift, Real t_max) {
    const Vec3 o = (shift == 0 ? ray.o : ray.at(shift)) * scale;
    const Float4 org{static_cast<float>(o.x), static_cast<float>(o.y), static_cast<float>(o.z), 0};
    const Float4 dir{static_cast<float>(ray.d.x), static_cast<float>(ray.d.y),
                     static_cast<float>(ray.d.z), 0};
    const Float4 rest{static_cast<float>((t_max - shift) * scale), std::bit_cast<float>(~0U), 0, 0};
    static_assert(offsetof(RTCRay, tnear) == 12 && offsetof(RTCRay, dir_x) == 16 &&
                  offsetof(RTCRay, tfar) == 32 && offsetof(RTCRay, mask) == 36);
    std::memcpy(&r.org_x, &org, sizeof(org));
    std::memcpy(&r.dir_x, &dir, sizeof(dir));
    std::memcpy(&r.tfar, &rest, sizeof(rest));
}

void set_owner(Hit& hit, std::size_t part, PartOwner owner) {
    hit.part = static_cast<std::uint32_t>(part);
    hit.object = owner.object;
    hit.instance = owner.instance;
}

/// The nearest surface that Embree knows; false when there is none.
bool intersect_bvh(const GeometryData& data, const Ray& ray, Real t_max, Hit& hit) {
    AnalyticQuery query(ray);
    query.shift = approach(ray, data.radius);
    if (!(query.shift < t_max)) return false;
    RTCRayHit record;
    set_ray(record.ray, ray, data.scale, query.shift, t_max);
    const float tfar = record.ray.tfar;
    bool triangle = false;
    std::uint32_t mesh = 0;
    for (int i = 0; i < kMaxRetries; ++i) {
        record.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        record.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        embree_intersect(data.scene.get(), record, query);
        if (record.hit.geomID == RTC_INVALID_GEOMETRY_ID) break;
        const bool instance = record.hit.instID[0] != RTC_INVALID_GEOMETRY_ID;
        mesh = instance ? record.hit.instID[0] : record.hit.geomID;
        if (mesh >= data.num_meshes) break;
        const TriangleHit at{record.hit.primID,
                             static_cast<Real>(record.ray.tfar) * data.unscale + query.shift,
                             record.hit.u, record.hit.v};
        triangle = data.meshes[mesh].refine(ray, at, hit);
        if (triangle) break;
        record.ray.tnear = std::nextafter(record.ray.tfar, std::numeric_limits<float>::infinity());
        record.ray.tfar = tfar;
    }
    if (query.best.t < kInfinity && !(triangle && hit.t <= query.best.t)) {
        data.analytic->shapes[query.best_shape].complete(ray, query.best, hit);
        set_owner(hit, data.num_meshes + query.best_shape, data.analytic->owners[query.best_shape]);
        return true;
    }
    if (!triangle) return false;
    data.meshes[mesh].shade(hit);
    set_owner(hit, mesh, data.mesh_owners[mesh]);
    return true;
}

/// Whether `hit`, which is nearer than the plane, cannot be told from it: something stands on it.
bool stands_on(const PlanePart& plane, Real t_plane, const Hit& hit) {
    return t_plane - hit.t <= 1e3 * hit.error &&
           std::abs(dot(plane.n, hit.p) - plane.offset) <= hit.error;
}

}  // namespace

std::optional<Hit> EmbreeGeometry::intersect(const Ray& ray) const {
    return intersect_within(ray, kInfinity);
}

std::optional<Hit> EmbreeGeometry::intersect_within(const Ray& ray, Real t_max) const {
    std::optional<Hit> result;
    if (!is_finite(ray) || !(t_max > 0)) return result;
    Real t_plane = kInfinity;
    std::size_t plane = 0;
    for (std::size_t i = 0; i < data_.planes.size(); ++i) {
        const Real t = distance_to(data_.planes[i], ray);
        if (t < t_plane) {
            t_plane = t;
            plane = i;
        }
    }
    Hit& hit = result.emplace();
    const bool found = data_.scene && intersect_bvh(data_, ray, std::min(t_plane, t_max), hit);
    const bool tied = found && hit.t < t_plane && t_plane < kInfinity &&
                      stands_on(data_.planes[plane], t_plane, hit);
    const bool plane_first = t_plane < kInfinity && (tied || !(found && hit.t < t_plane));
    if (plane_first) {
        const Real error = tied ? hit.error : 0;
        complete(data_.planes[plane], ray, t_plane, hit);
        hit.error = std::max(hit.error, error);
        set_owner(hit, data_.num_meshes + data_.analytic->shapes.size() + plane,
                  data_.planes[plane].owner);
    }
    if (!(plane_first || found) || !(hit.t < t_max)) result.reset();
    return result;
}

bool EmbreeGeometry::occluded(const Ray& ray, Real t_max) const {
    if (!is_finite(ray) || !(t_max > 0)) return false;
    for (const PlanePart& plane : data_.planes) {
        if (distance_to(plane, ray) < t_max) return true;
    }
    if (!data_.scene) return false;
    AnalyticQuery query(ray);
    query.t_max = t_max;
    query.shift = approach(ray, data_.radius);
    if (!(query.shift < t_max)) return false;
    RTCRay record;
    set_ray(record, ray, data_.scale, query.shift, t_max);
    embree_occluded(data_.scene.get(), record, query);
    return record.tfar < 0;
}

Vec2 EmbreeGeometry::surface_uv(const Hit& hit) const {
    std::size_t part = hit.part;
    if (part < data_.num_meshes) return data_.meshes[part].uv(hit);
    part -= data_.num_meshes;
    if (part < data_.analytic->shapes.size()) return data_.analytic->shapes[part].uv(hit);
    const Frame frame(hit.ng);
    return {dot(frame.x, hit.p + data_.origin), dot(frame.y, hit.p + data_.origin)};
}

std::uint64_t EmbreeGeometry::memory_bytes() const {
    const auto embree = data_.memory->bytes.load(std::memory_order_relaxed);
    return data_.own_bytes + static_cast<std::uint64_t>(std::max<std::int64_t>(embree, 0));
}

}  // namespace bouguer::renderer
