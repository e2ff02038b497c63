// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/embree_geometry.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <tuple>

namespace bouguer::renderer {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

bool is_finite(const Ray& ray) {
    const Real sum = ray.o.x + ray.o.y + ray.o.z + ray.d.x + ray.d.y + ray.d.z;
    return sum - sum == 0;
}

/// Negative behind the ray's origin; not finite along the plane.
Real crossing_of(const PlanePart& plane, const Ray& ray) {
    return (plane.offset - dot(plane.n, ray.o)) / dot(plane.n, ray.d);
}

Real distance_to(const PlanePart& plane, const Ray& ray) {
    const Real t = crossing_of(plane, ray);
    return t > 0 ? t : kInfinity;
}

void complete(const PlanePart& plane, const Ray& ray, Real t, Hit& hit) {
    const Vec3 p = ray.at(t);
    hit.t = t;
    hit.p = p + (plane.offset - dot(plane.n, p)) * plane.n;
    hit.ng = hit.ns = plane.n;
    hit.error = plane.placing + 0x1p-41 * (max_abs(hit.p) + std::abs(plane.offset));
    hit.resolution = hit.error;
    hit.is_at_edge = false;
    hit.primitive = 0;
}

/// Four floats that are stored at once: Embree loads them so, and would wait for single stores.
using Float4 = float __attribute__((vector_size(16)));

/// The nearest surface that Embree knows; false when there is none.
bool intersect_bvh(const GeometryData& data, const Ray& ray, Real t_max, Hit& hit) {
    GeometryQuery query(data, ray);
    query.shift = approach(ray, data.radius);
    if (!(query.shift < t_max)) return false;
    RTCRayHit record;
    set_ray(record.ray, ray, data.scale, query.shift, t_max);
    const bool triangle = nearest_triangle(
        data.scene.get(), record, query, data.scale, query.shift,
        [&](std::uint32_t id) { return id < data.num_meshes ? id : GeometryQuery::kNoPart; }, hit);
    if (query.best_part != GeometryQuery::kNoPart && !(triangle && hit.t <= query.best_t)) {
        if (query.best_part < data.num_meshes) {
            hit = query.best_triangle;
        } else {
            const std::uint32_t shape = query.best_part - data.num_meshes;
            data.analytic->shapes[shape].complete(ray, query.best_shape, hit);
            set_owner(hit, query.best_part, data.analytic->owners[shape]);
            hit.is_alone = query.is_alone && data.num_meshes == 0;
            return true;
        }
    } else if (!triangle) {
        return false;
    }
    data.meshes[hit.part].shade(hit);
    return true;
}

/// Whether `hit`, which is nearer than the plane, is in one place with it: something stands on it.
bool stands_on(const PlanePart& plane, Real t_plane, const Hit& hit) {
    return t_plane - hit.t <= 1e3 * hit.error &&
           std::abs(dot(plane.n, hit.p) - plane.offset) <= hit.resolution;
}

/// By how much single precision may see a ray's end off, scene units. The filter and the shapes
/// decide in double.
Real slack(const GeometryData& data) { return 0x1p-18 * data.radius; }

}  // namespace

Real approach(const Ray& ray, Real radius) {
    if (max_abs(ray.o) <= 8 * radius) return 0;
    const Real along = -dot(ray.o, ray.d);
    if (along <= 0) return kInfinity;
    if (max_abs(ray.at(along)) > 2 * radius) return kInfinity;
    return along - 4 * radius;
}

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

bool EmbreeGeometry::nearest(const Ray& ray, Real t_max, Hit& hit) const {
    if (!is_finite(ray) || !(t_max > 0)) return false;
    Real t_plane = kInfinity;
    std::size_t plane = 0;
    for (std::size_t i = 0; i < data_.planes.size(); ++i) {
        const Real t = distance_to(data_.planes[i], ray);
        if (t < t_plane) {
            t_plane = t;
            plane = i;
        }
    }
    const bool found = data_.scene && intersect_bvh(data_, ray, std::min(t_plane, t_max), hit);
    const bool tied = found && hit.t < t_plane && t_plane < kInfinity &&
                      stands_on(data_.planes[plane], t_plane, hit);
    const bool plane_first = t_plane < kInfinity && (tied || !(found && hit.t < t_plane));
    if (plane_first) {
        const Real error = tied ? hit.error : 0;
        complete(data_.planes[plane], ray, t_plane, hit);
        hit.error = std::max(hit.error, error);
        set_owner(hit, first_plane() + plane, data_.planes[plane].owner);
    }
    if (!data_.planes.empty()) hit.is_alone = false;
    return (plane_first || found) && hit.t < t_max - resolution_along(hit, ray.d);
}

bool EmbreeGeometry::occluded(const Ray& ray, Real t_max) const {
    if (!is_finite(ray) || !(t_max > 0)) return false;
    GeometryQuery query(data_, ray);
    query.t_max = t_max;
    for (const PlanePart& plane : data_.planes) {
        const Real t = distance_to(plane, ray);
        if (!(t < t_max)) continue;
        Hit hit;
        complete(plane, ray, t, hit);
        if (query.meets(hit)) return true;
    }
    if (!data_.scene) return false;
    query.shift = approach(ray, data_.radius);
    query.scale = data_.scale;
    if (!(query.shift < t_max)) return false;
    RTCRay record;
    set_ray(record, ray, data_.scale, query.shift, t_max + slack(data_));
    embree_occluded(data_.scene.get(), record, query);
    return record.tfar < 0;
}

void EmbreeGeometry::crossings(const Ray& ray, Real from, Real to,
                               std::vector<Hit>& crossings) const {
    crossings.clear();
    if (!is_finite(ray) || !(from <= to)) return;
    GeometryQuery query(data_, ray);
    query.crossings = &crossings;
    query.from = from;
    query.t_max = to;
    for (std::size_t i = 0; i < data_.planes.size(); ++i) {
        const Real t = crossing_of(data_.planes[i], ray);
        if (!std::isfinite(t)) continue;
        Hit hit;
        complete(data_.planes[i], ray, t, hit);
        set_owner(hit, first_plane() + i, data_.planes[i].owner);
        query.meets(hit);
    }
    query.scale = data_.scale;
    query.shift = from - slack(data_);
    query.shift += approach({ray.at(query.shift), ray.d}, data_.radius);
    if (data_.scene && query.shift <= to) {
        RTCRay record;
        set_ray(record, ray, data_.scale, query.shift, to + slack(data_));
        embree_occluded(data_.scene.get(), record, query);
    }
    std::sort(crossings.begin(), crossings.end(), [](const Hit& a, const Hit& b) {
        return std::tie(a.t, a.object, a.instance, a.primitive) <
               std::tie(b.t, b.object, b.instance, b.primitive);
    });
    settle_edges(ray.d, crossings);
}

/// A line through an edge or a corner of a mesh crosses it once, though Embree finds every triangle
/// there; and one that passes a silhouette outside, by less than single precision tells, does not
/// cross it, though Embree finds the triangles of both sides.
void EmbreeGeometry::settle_edges(Vec3 d, std::vector<Hit>& crossings) const {
    const auto erase = [&](std::size_t i) {
        crossings.erase(crossings.begin() + static_cast<std::ptrdiff_t>(i));
    };
    for (std::size_t i = 1; i < crossings.size(); ++i) {
        const Hit& hit = crossings[i];
        if (hit.part >= data_.num_meshes) continue;
        const MeshPart& mesh = data_.meshes[hit.part];
        for (std::size_t j = i; j-- > 0;) {
            const Hit& before = crossings[j];
            const Real both = hit.error + before.error;
            const Real steepest = std::min(std::abs(dot(hit.ng, d)), std::abs(dot(before.ng, d)));
            if ((hit.t - before.t) * std::max(steepest, 1e-3) > both) break;
            if (before.part != hit.part || !mesh.share_corner(before, hit)) continue;
            const bool is_silhouette = dot(before.ng, d) * dot(hit.ng, d) <= 0;
            if (is_silhouette && !(mesh.is_beside(before) && mesh.is_beside(hit))) continue;
            erase(i--);
            if (is_silhouette) {
                erase(j);
                if (i > 0) --i;
            }
            break;
        }
    }
}

Real EmbreeGeometry::reach(const Hit& hit) const {
    return hit.is_alone ? hit.error : std::max(hit.error, data_.mesh_reach);
}

bool EmbreeGeometry::contains(std::uint32_t object, std::uint32_t instance, Vec3 p) const {
    const std::size_t part = part_of(object, instance);
    if (part >= first_plane()) {
        const PlanePart& plane = data_.planes[part - first_plane()];
        return dot(plane.n, p) < plane.offset;
    }
    if (part >= data_.num_meshes) {
        return data_.analytic->shapes[part - data_.num_meshes].contains(p);
    }
    const Bounds& box = data_.mesh_bounds[part];
    if (min(box.lo, p) != box.lo || max(box.hi, p) != box.hi) return false;
    // Directions along no axis and no diagonal, so that they meet few edges.
    constexpr std::array<Vec3, 3> kDirections{Vec3{0.48, 0.64, 0.6}, Vec3{-0.36, 0.48, -0.8},
                                              Vec3{0.64, -0.6, 0.48}};
    int votes = 0;
    std::vector<Hit> all;
    for (const Vec3 d : kDirections) {
        crossings({p, d}, 0, kInfinity, all);
        int bodies = 0;
        for (const Hit& hit : all) {
            if (hit.part == part) bodies += dot(hit.ng, d) > 0 ? 1 : -1;
        }
        if (bodies > 0) ++votes;
    }
    return votes >= 2;
}

bool EmbreeGeometry::touches(std::uint32_t object, std::uint32_t instance, Vec3 p,
                             Real reach) const {
    const std::size_t part = part_of(object, instance);
    if (part < data_.num_meshes) return data_.meshes[part].touches(p, reach);
    if (part < first_plane())
        return data_.analytic->shapes[part - data_.num_meshes].touches(p, reach);
    const PlanePart& plane = data_.planes[part - first_plane()];
    return std::abs(dot(plane.n, p) - plane.offset) <= reach;
}

bool EmbreeGeometry::is_thin(std::uint32_t object, std::uint32_t instance) const {
    constexpr Real kThin = 16;  // of what queries confuse
    const std::size_t part = part_of(object, instance);
    if (part >= first_plane()) return false;
    if (part >= data_.num_meshes) {
        const AnalyticShape& shape = data_.analytic->shapes[part - data_.num_meshes];
        return shape.thinnest() > 0 && shape.thinnest() <= kThin * data_.mesh_reach;
    }
    const MeshPart& mesh = data_.meshes[part];
    std::vector<Hit> all;
    Hit own;
    for (std::uint32_t i = 0; i < mesh.mesh().triangles.size(); ++i) {
        const Vec3 p = mesh.middle_of(i);
        mesh.refine({p, {0, 0, 1}}, {i, 0, 1.F / 3, 1.F / 3}, own);
        crossings({p, -own.ng}, 0, kThin * data_.mesh_reach, all);
        for (const Hit& hit : all) {
            if (hit.part == part && !mesh.share_corner(own, hit)) return true;
        }
    }
    return false;
}

Bounds EmbreeGeometry::bounds(std::uint32_t object, std::uint32_t instance) const {
    const std::size_t part = part_of(object, instance);
    if (part < data_.num_meshes) return data_.mesh_bounds[part];
    if (part < first_plane()) return data_.analytic->shapes[part - data_.num_meshes].bounds();
    return {Vec3{-1, -1, -1} * kInfinity, Vec3{1, 1, 1} * kInfinity};
}

Vec2 EmbreeGeometry::surface_uv(const Hit& hit) const {
    std::size_t part = hit.part;
    if (part < data_.num_meshes) return data_.meshes[part].uv(hit);
    part -= data_.num_meshes;
    if (part < data_.analytic->shapes.size()) return data_.analytic->shapes[part].uv(hit);
    return data_.plane_coordinates[part - data_.analytic->shapes.size()].at(hit.p);
}

Vec3 EmbreeGeometry::smooth_point(const Hit& hit) const {
    return hit.part < data_.num_meshes ? data_.meshes[hit.part].smooth_point(hit) : hit.p;
}

std::uint64_t EmbreeGeometry::memory_bytes() const {
    const auto embree = data_.memory->bytes.load(std::memory_order_relaxed);
    return data_.own_bytes + static_cast<std::uint64_t>(std::max<std::int64_t>(embree, 0));
}

}  // namespace bouguer::renderer
