// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/analytic_set.h"

#include <cmath>
#include <limits>

#include "renderer/core/thread_sanitizer.h"
#include "renderer/geometry/geometry_query.h"

namespace bouguer::renderer {
namespace {

/// Whether `hit` on part number `part` comes before the best so far. Notes what is as near.
bool comes_first(GeometryQuery& query, Real resolution, std::uint32_t part,
                 const AnalyticHit& hit) {
    constexpr Real kReach = 64;  // resolutions: also what is a little farther is not alone
    if (query.best_part == GeometryQuery::kNoPart) return true;
    if (std::abs(hit.t - query.best_t) <= kReach * resolution) query.is_alone = false;
    if (hit.t < query.best_t - resolution) return true;
    if (hit.t > query.best_t + resolution) return false;
    return hit.rank != query.best_rank ? hit.rank > query.best_rank : part < query.best_part;
}

void bound(const RTCBoundsFunctionArguments* args) {
    const auto& set = *static_cast<const AnalyticSet*>(args->geometryUserPtr);
    write_bounds(*args->bounds_o, set.shapes[args->primID].bounds(), set.margin, set.scale);
    happens_before(&set);  // called by Embree's build threads; the end of the build waits for them
}

void intersect(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& set = *static_cast<const AnalyticSet*>(args->geometryUserPtr);
    auto& query = static_cast<GeometryQuery&>(*args->context);
    const AnalyticShape& shape = set.shapes[args->primID];
    const AnalyticHit hit = shape.intersect(*query.ray);
    float& tfar = RTCRayN_tfar(RTCRayHitN_RayN(args->rayhit, args->N), args->N, 0);
    if (!((hit.t - query.shift) * set.scale <= static_cast<Real>(tfar))) return;
    const std::uint32_t part = set.first_part + args->primID;
    if (!comes_first(query, shape.resolution_at(hit.t), part, hit)) return;
    query.best_t = hit.t;
    query.best_rank = hit.rank;
    query.best_shape = hit;
    query.best_part = part;
    // Rounded upwards, so that Embree still shows us what is equally near.
    const Real reach = (hit.t + 64 * shape.resolution_at(hit.t) - query.shift) * set.scale;
    tfar = std::nextafter(static_cast<float>(reach), std::numeric_limits<float>::infinity());
    RTCHitN* record = RTCRayHitN_HitN(args->rayhit, args->N);
    RTCHitN_geomID(record, args->N, 0) = args->geomID;
    RTCHitN_primID(record, args->N, 0) = args->primID;
    RTCHitN_instID(record, args->N, 0, 0) = RTC_INVALID_GEOMETRY_ID;
}

/// Whether a crossing blocks a ray. What is well before its end needs no look at the normal.
bool blocks(GeometryQuery& query, const AnalyticShape& shape, const AnalyticHit& at) {
    constexpr Real kNearTheEnd = 0x1p20;  // of what grazing incidence may make of a resolution
    if (!(at.t > 0 && at.t < query.t_max)) return false;
    if (at.t + kNearTheEnd * shape.resolution_at(at.t) < query.t_max) return true;
    Hit hit;
    shape.complete(*query.ray, at, hit);
    return query.meets(hit);
}

void cross(GeometryQuery& query, const AnalyticSet& set, std::uint32_t index) {
    for (const AnalyticHit& at : set.shapes[index].crossings(*query.ray)) {
        if (!std::isfinite(at.t)) continue;
        Hit hit;
        set.shapes[index].complete(*query.ray, at, hit);
        set_owner(hit, set.first_part + index, set.owners[index]);
        query.meets(hit);
    }
}

void occlude(const RTCOccludedFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& set = *static_cast<const AnalyticSet*>(args->geometryUserPtr);
    auto& query = static_cast<GeometryQuery&>(*args->context);
    if (query.crossings != nullptr) return cross(query, set, args->primID);
    const AnalyticShape& shape = set.shapes[args->primID];
    if (blocks(query, shape, shape.intersect(*query.ray))) {
        RTCRayN_tfar(args->ray, args->N, 0) = -std::numeric_limits<float>::infinity();
    }
}

}  // namespace

void write_bounds(RTCBounds& to, const Bounds& box, Real margin, Real scale) {
    const Vec3 lo = scale * (box.lo - margin * Vec3{1, 1, 1});
    const Vec3 hi = scale * (box.hi + margin * Vec3{1, 1, 1});
    to.lower_x = static_cast<float>(lo.x);
    to.lower_y = static_cast<float>(lo.y);
    to.lower_z = static_cast<float>(lo.z);
    to.upper_x = static_cast<float>(hi.x);
    to.upper_y = static_cast<float>(hi.y);
    to.upper_z = static_cast<float>(hi.z);
}

GeometryHandle make_analytic_geometry(RTCDevice device, AnalyticSet& set) {
    GeometryHandle geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(set.shapes.size()));
    rtcSetGeometryUserData(geometry.get(), &set);
    rtcSetGeometryBoundsFunction(geometry.get(), bound, nullptr);
    rtcSetGeometryIntersectFunction(geometry.get(), intersect);
    rtcSetGeometryOccludedFunction(geometry.get(), occlude);
    return geometry;
}

}  // namespace bouguer::renderer
