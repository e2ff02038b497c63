// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/analytic_set.h"

#include <cmath>
#include <limits>

#include "renderer/core/thread_sanitizer.h"

namespace bouguer::renderer {
namespace {

/// Whether `hit` on shape number `index` comes before the best so far.
bool comes_first(const AnalyticQuery& query, const AnalyticShape& shape, std::uint32_t index,
                 const AnalyticHit& hit) {
    const AnalyticHit& best = query.best;
    if (best.t == std::numeric_limits<Real>::infinity()) return true;
    const Real resolution = shape.resolution_at(hit.t);
    if (hit.t < best.t - resolution) return true;
    if (hit.t > best.t + resolution) return false;
    return hit.rank != best.rank ? hit.rank > best.rank : index < query.best_shape;
}

void bound(const RTCBoundsFunctionArguments* args) {
    const auto& set = *static_cast<const AnalyticSet*>(args->geometryUserPtr);
    const Bounds bounds = set.shapes[args->primID].bounds();
    const Vec3 margin = Vec3{1, 1, 1} * set.margin;
    const Vec3 lo = set.scale * (bounds.lo - margin);
    const Vec3 hi = set.scale * (bounds.hi + margin);
    args->bounds_o->lower_x = static_cast<float>(lo.x);
    args->bounds_o->lower_y = static_cast<float>(lo.y);
    args->bounds_o->lower_z = static_cast<float>(lo.z);
    args->bounds_o->upper_x = static_cast<float>(hi.x);
    args->bounds_o->upper_y = static_cast<float>(hi.y);
    args->bounds_o->upper_z = static_cast<float>(hi.z);
    happens_before(&set);  // called by Embree's build threads; the end of the build waits for them
}

void intersect(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& set = *static_cast<const AnalyticSet*>(args->geometryUserPtr);
    auto& query = static_cast<AnalyticQuery&>(*args->context);
    const AnalyticShape& shape = set.shapes[args->primID];
    const AnalyticHit hit = shape.intersect(*query.ray);
    float& tfar = RTCRayN_tfar(RTCRayHitN_RayN(args->rayhit, args->N), args->N, 0);
    if (!((hit.t - query.shift) * set.scale <= static_cast<Real>(tfar))) return;
    if (!comes_first(query, shape, args->primID, hit)) return;
    query.best = hit;
    query.best_shape = args->primID;
    // Rounded upwards, so that Embree still shows us what is equally near.
    const Real reach = (hit.t + shape.resolution_at(hit.t) - query.shift) * set.scale;
    tfar = std::nextafter(static_cast<float>(reach), std::numeric_limits<float>::infinity());
    RTCHitN* record = RTCRayHitN_HitN(args->rayhit, args->N);
    RTCHitN_geomID(record, args->N, 0) = args->geomID;
    RTCHitN_primID(record, args->N, 0) = args->primID;
    RTCHitN_instID(record, args->N, 0, 0) = RTC_INVALID_GEOMETRY_ID;
}

void occlude(const RTCOccludedFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& set = *static_cast<const AnalyticSet*>(args->geometryUserPtr);
    const auto& query = static_cast<const AnalyticQuery&>(*args->context);
    if (set.shapes[args->primID].intersect(*query.ray).t < query.t_max) {
        RTCRayN_tfar(args->ray, args->N, 0) = -std::numeric_limits<float>::infinity();
    }
}

}  // namespace

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
