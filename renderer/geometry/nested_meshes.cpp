// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/nested_meshes.h"

#include <cmath>
#include <limits>

#include "renderer/core/thread_sanitizer.h"
#include "renderer/geometry/embree_geometry.h"
#include "renderer/geometry/geometry_query.h"

namespace bouguer::renderer {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
/// Buffers of own scenes lie about zero and reach less than 2 along each axis.
constexpr Real kBufferRadius = 3.5;

/// A ray in a mesh's own coordinates, for Embree.
struct LocalRay {
    LocalRay(const MeshPart& mesh, const Ray& ray) {
        const Vec3 d = mesh.to_buffer().direction(ray.d);
        unit = length(d);
        local = {mesh.to_buffer().point(ray.o), d / unit};
    }

    /// Fills `r` with the part of the ray between `near` and `far`, scene units; false when that
    /// passes the mesh by. Lengths in `r` are (t - shift) * unit.
    bool set(RTCRay& r, Real near, Real far) {
        const Real start = near * unit + approach({local.at(near * unit), local.d}, kBufferRadius);
        shift = start / unit;
        if (!(shift < far)) return false;
        set_ray(r, local, 1, start, far * unit);
        return true;
    }

    Ray local;
    Real unit = 1;   ///< how long a scene unit is
    Real shift = 0;  ///< scene units
};

void bound(const RTCBoundsFunctionArguments* args) {
    const auto& set = *static_cast<const NestedMeshes*>(args->geometryUserPtr);
    write_bounds(*args->bounds_o, set.bounds[args->primID], set.margin, set.scale);
    happens_before(&set);  // as for analytic shapes
}

void intersect(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& set = *static_cast<const NestedMeshes*>(args->geometryUserPtr);
    auto& query = static_cast<GeometryQuery&>(*args->context);
    const NestedMesh& nested = set.meshes[args->primID];
    const MeshPart& mesh = query.data->meshes[nested.part];
    float& tfar = RTCRayN_tfar(RTCRayHitN_RayN(args->rayhit, args->N), args->N, 0);
    const Real far = static_cast<Real>(tfar) / set.scale + query.shift;
    LocalRay local(mesh, *query.ray);
    RTCRayHit record;
    if (!local.set(record.ray, 0, far)) return;
    GeometryQuery own = query.of_part(nested.part);
    Hit hit;
    if (!nearest_triangle(
            nested.scene, record, own, local.unit, local.shift,
            [&](std::uint32_t) { return nested.part; }, hit)) {
        return;
    }
    const bool is_first = query.best_part == GeometryQuery::kNoPart || hit.t < query.best_t ||
                          (hit.t == query.best_t && nested.part < query.best_part);
    if (!is_first) return;
    query.best_t = hit.t;
    query.best_rank = dot(query.ray->d, hit.ng) < 0 ? CrossingRank::Enters : CrossingRank::Leaves;
    query.best_part = nested.part;
    query.best_triangle = hit;
    tfar = std::nextafter(static_cast<float>((hit.t - query.shift) * set.scale),
                          std::numeric_limits<float>::infinity());
    RTCHitN* to = RTCRayHitN_HitN(args->rayhit, args->N);
    RTCHitN_geomID(to, args->N, 0) = args->geomID;
    RTCHitN_primID(to, args->N, 0) = args->primID;
    RTCHitN_instID(to, args->N, 0, 0) = RTC_INVALID_GEOMETRY_ID;
}

void occlude(const RTCOccludedFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& set = *static_cast<const NestedMeshes*>(args->geometryUserPtr);
    const auto& query = static_cast<GeometryQuery&>(*args->context);
    const NestedMesh& nested = set.meshes[args->primID];
    LocalRay local(query.data->meshes[nested.part], *query.ray);
    // Single precision sees crossings a little off; the filter decides in double.
    const bool collects = query.crossings != nullptr;
    const Real slack = 0x1p-18 * (kBufferRadius / local.unit);
    RTCRay record;
    if (!local.set(record, collects ? query.from - slack : 0, query.t_max + slack)) return;
    GeometryQuery own = query.of_part(nested.part);
    own.scale = local.unit;
    own.shift = local.shift;
    embree_occluded(nested.scene, record, own);
    if (record.tfar < 0)
        RTCRayN_tfar(args->ray, args->N, 0) = -std::numeric_limits<float>::infinity();
}

}  // namespace

GeometryHandle make_nested_geometry(RTCDevice device, NestedMeshes& set) {
    GeometryHandle geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(set.meshes.size()));
    rtcSetGeometryUserData(geometry.get(), &set);
    rtcSetGeometryBoundsFunction(geometry.get(), bound, nullptr);
    rtcSetGeometryIntersectFunction(geometry.get(), intersect);
    rtcSetGeometryOccludedFunction(geometry.get(), occlude);
    return geometry;
}

}  // namespace bouguer::renderer
