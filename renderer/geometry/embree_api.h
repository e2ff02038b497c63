// SPDX-License-Identifier: Apache-2.0
// The parts of Embree 3 and of Embree 4 that differ, under one name. BOUGUER_EMBREE_MAJOR comes
// from CMake.
#pragma once

#include <memory>
#include <type_traits>

#if BOUGUER_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace bouguer::renderer {

#if BOUGUER_EMBREE_MAJOR >= 4

/// What a query carries to the callbacks; derive from it to carry more.
using EmbreeContext = RTCRayQueryContext;

inline void init_context(EmbreeContext& context) { rtcInitRayQueryContext(&context); }

inline void embree_intersect(RTCScene scene, RTCRayHit& ray, EmbreeContext& context) {
    RTCIntersectArguments args;
    rtcInitIntersectArguments(&args);
    args.context = &context;
    rtcIntersect1(scene, &ray, &args);
}

inline void embree_occluded(RTCScene scene, RTCRay& ray, EmbreeContext& context) {
    RTCOccludedArguments args;
    rtcInitOccludedArguments(&args);
    args.context = &context;
    rtcOccluded1(scene, &ray, &args);
}

#else

/// What a query carries to the callbacks; derive from it to carry more.
using EmbreeContext = RTCIntersectContext;

inline void init_context(EmbreeContext& context) { rtcInitIntersectContext(&context); }

inline void embree_intersect(RTCScene scene, RTCRayHit& ray, EmbreeContext& context) {
    rtcIntersect1(scene, &context, &ray);
}

inline void embree_occluded(RTCScene scene, RTCRay& ray, EmbreeContext& context) {
    rtcOccluded1(scene, &context, &ray);
}

#endif

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct ReleaseGeometry {
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};

/// Embree's handles as owners: each releases its reference.
using DeviceHandle = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice>;
using SceneHandle = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;
using GeometryHandle = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, ReleaseGeometry>;

}  // namespace bouguer::renderer
