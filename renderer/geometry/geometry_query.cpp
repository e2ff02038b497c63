// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/geometry_query.h"

#include "renderer/geometry/embree_geometry.h"

namespace bouguer::renderer {
namespace {

/// Called by occlusion queries for every triangle that single precision finds.
void filter(const RTCFilterFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    auto& query = static_cast<GeometryQuery&>(*args->context);
    const bool is_main = query.part == GeometryQuery::kNoPart;
    const std::uint32_t part = is_main ? RTCHitN_geomID(args->hit, args->N, 0) : query.part;
    const TriangleHit at{
        RTCHitN_primID(args->hit, args->N, 0),
        static_cast<Real>(RTCRayN_tfar(args->ray, args->N, 0)) / query.scale + query.shift,
        RTCHitN_u(args->hit, args->N, 0), RTCHitN_v(args->hit, args->N, 0)};
    Hit hit;
    query.data->meshes[part].refine(*query.ray, at, hit);
    set_owner(hit, part, query.data->mesh_owners[part]);
    if (query.crossings != nullptr) query.data->meshes[part].shade(hit);
    if (!query.meets(hit)) args->valid[0] = 0;
}

}  // namespace

void set_triangle_filter(RTCGeometry geometry) {
    rtcSetGeometryOccludedFilterFunction(geometry, filter);
}

}  // namespace bouguer::renderer
